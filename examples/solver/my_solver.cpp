// Dijkstra's algorithm on the edges of the mesh and on straight lines across one edge, from the
// corner of a face to the far corner of the face beyond it. An upper bound of the geodesic
// distance.
#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/registry.h"

namespace {

using namespace geodesic;

class MySolver final : public Solver {
 public:
  MySolver(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), front_(mesh.vertex_count()) {}

 private:
  void run(const Start& start, std::span<double> distances) override {
    const auto improve = [&](Index v, double d) {
      if (d < distances[v]) {
        distances[v] = d;
        front_.push_or_decrease(v, d);
      }
    };
    for (const StartVertex& each : start.vertices) improve(each.vertex, each.distance);
    while (!front_.empty() && front_.least_key() <= start.query.limit) {
      const Index v = front_.pop();
      for (const Index h : mesh().outgoing(v)) {
        const Index opposite = Mesh::next(h), into = Mesh::previous(h);
        improve(mesh().head(h), distances[v] + mesh().half_edge(h).length);
        improve(mesh().origin(into), distances[v] + mesh().half_edge(into).length);
        if (mesh().twin(opposite) == kNone) continue;
        improve(mesh().apex(mesh().twin(opposite)), distances[v] + line_across(opposite));
      }
    }
    front_.clear();
  }

  // Length of the straight line from the apex of h to that of its twin, with both faces in one
  // plane; infinite if the line does not cross the edge.
  double line_across(Index h) const {
    const HalfEdge& near = mesh().half_edge(h);
    const HalfEdge& far = mesh().half_edge(near.twin);
    const double dx = near.length - far.apex_x - near.apex_x;
    const double dy = near.apex_y + far.apex_y;
    const double crossing = near.apex_x + dx * near.apex_y / dy;
    return crossing >= 0 && crossing <= near.length ? norm(Point2{dx, dy}) : kInfinity;
  }

  VertexHeap front_;
};

const RegisterSolver<MySolver> registered{{
    .name = "my-solver",
    .family = "Dijkstra",
    .paper = "Dijkstra 1959, A note on two problems in connexion with graphs",
    .exactness = Exactness::upper_bound,
}};

}  // namespace
