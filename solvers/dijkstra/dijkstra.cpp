// Dijkstra's algorithm on the graph of edges: an upper bound of the geodesic distance, and a floor
// for the time that any solver can take.
//
// Dijkstra 1959, "A note on two problems in connexion with graphs".
#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

class Dijkstra final : public Solver {
 public:
  Dijkstra(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), front_(mesh.vertex_count()) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    const auto reach = [&](Index v, double d) {
      if (d < distances[v]) {
        distances[v] = d;
        front_.push_or_decrease(v, d);
      }
    };
    for (const Source& source : query.sources) reach(source.at.vertex, source.distance);
    StopRule ending(mesh(), query, distances);
    while (!front_.empty() && !ending.is_over(front_.least_key())) {
      const Index v = front_.pop();
      for (const Index h : mesh().outgoing(v)) {
        // Both edges of the corner: a boundary edge leaves v in one face only.
        const Index into = Mesh::previous(h);
        reach(mesh().head(h), distances[v] + mesh().half_edge(h).length);
        reach(mesh().origin(into), distances[v] + mesh().half_edge(into).length);
      }
    }
    front_.clear();
  }

  VertexHeap front_;
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
