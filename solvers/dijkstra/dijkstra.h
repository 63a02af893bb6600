// Dijkstra's algorithm on the graph of edges: an upper bound of the geodesic distance, and a floor
// for the time that any solver can take.
//
// Dijkstra 1959, "A note on two problems in connexion with graphs". Vertices are popped in the
// order of buckets, and one that is found to be nearer afterwards is popped again: the distances
// are the same bits as in strict order, since adding an edge never makes the greater of two the
// smaller.
#pragma once

#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/core/solver.h"

namespace geodesic {

class Dijkstra : public Solver {
 public:
  Dijkstra(const Mesh& mesh, const Description& description);

 protected:
  /// Along edges, from the end back: a neighbour comes before a vertex if it is as far as that one
  /// less their edge, to the last bit.
  std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                        std::span<const double> distances, Index vertex) override;

 private:
  void run(const InternalQuery& query, std::span<double> distances, Recording* recording) override;

  VertexCalendar front_;
};

}  // namespace geodesic
