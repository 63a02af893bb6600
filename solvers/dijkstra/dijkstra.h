// Dijkstra's algorithm on the graph of edges: an upper bound of the geodesic distance, and a lower
// bound of the time of any solver.
//
// Dijkstra 1959, "A note on two problems in connexion with graphs". Vertices are popped in the
// order of buckets, and a vertex whose distance decreases afterwards is popped again. The distances
// have the same bits as in strict order, since adding an edge never makes the greater of two
// distances the smaller.
#pragma once

#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/core/solver.h"

namespace geodesic {

class Dijkstra : public Solver {
 public:
  Dijkstra(const Mesh& mesh, const Description& description);

 protected:
  /// Traces the path along edges, from its end. A neighbour precedes a vertex if its distance is
  /// that of the vertex minus their edge, to the last bit.
  std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                        std::span<const double> distances, Index vertex) override;

 private:
  void run(const Start& start, std::span<double> distances) override;

  VertexCalendar front_;
};

}  // namespace geodesic
