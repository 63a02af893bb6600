// Dijkstra's algorithm on the graph of edges: an upper bound of the geodesic distance, and a floor
// for the time that any solver can take.
//
// Dijkstra 1959, "A note on two problems in connexion with graphs". Vertices are popped in the
// order of buckets, and one that is found to be nearer afterwards is popped again: the distances
// are the same bits as in strict order, since adding an edge never makes the greater of two the
// smaller.
#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

class Dijkstra final : public Solver {
 public:
  Dijkstra(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        front_(mesh.vertex_count(), kBucketWidth * mesh.mean_edge_length()) {}

 private:
  /// In mean edge lengths. Narrower buckets are more to pass over, wider ones pop more vertices
  /// twice.
  static constexpr double kBucketWidth = 1;

  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    const auto reach = [&](Index v, double d) {
      if (d < distances[v]) {
        distances[v] = d;
        front_.push_or_decrease(v, d);
      }
    };
    for (const Source& source : query.sources) reach(source.at.vertex, source.distance);
    StopRule stop_rule(mesh(), query, distances);
    while (!front_.empty() && !stop_rule.is_over(front_.least_key())) {
      const Index v = front_.pop();
      const double d = distances[v];
      mesh().prefetch_faces_around(front_.upcoming());
      for (const Index h : mesh().outgoing(v)) {
        reach(mesh().head(h), d + mesh().half_edge(h).length);
        // An edge of two faces leaves v in one of them; any other one may only arrive.
        const Index into = Mesh::previous(h);
        if (mesh().twin(into) == kNone) {
          reach(mesh().origin(into), d + mesh().half_edge(into).length);
        }
      }
    }
    front_.clear();
  }

  VertexCalendar front_;
};

const RegisterSolver<Dijkstra> registered{{
    .name = "dijkstra",
    .family = "Dijkstra",
    .paper = "Dijkstra 1959, A note on two problems in connexion with graphs",
    .exactness = Exactness::upper_bound,
    .remarks = "paths along edges only",
}};

}  // namespace
}  // namespace geodesic
