// `straight-graph`: a graph of straight links, prepared once, for many sources on one mesh.
#include "solvers/core/registry.h"
#include "solvers/straight_graph/builder.h"
#include "solvers/straight_graph/search.h"

namespace geodesic::straight_graph {
namespace {

class StraightGraph final : public Solver {
 public:
  StraightGraph(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        graph_(build_graph(mesh, description.real("alpha"),
                           static_cast<unsigned>(description.integer("threads")))),
        search_(mesh, graph_, description.real("alpha")) {}

 private:
  void run(const InternalQuery& query, std::span<double> distances,
           Recording* /*recording*/) override {
    search_.run(query, distances);
  }

  Graph graph_;
  Search search_;
};

const RegisterSolver<StraightGraph> registered{{
    .name = "straight-graph",
    .family = "straight graph",
    .paper = "Ying, Wang, He 2013, Saddle Vertex Graph (SVG): A Novel Solution to the Discrete "
             "Geodesic Problem",
    .exactness = Exactness::upper_bound,
    .by_name_only = true,
    .abilities = {.surface_sources = true},
    .remarks = "prepares links once, for many sources",
    .parameters = {real_parameter("alpha", 0.2, 0.02, 1, "least angle between links, in radians"),
                   integer_parameter("threads", 1, 1, 256, "that prepare the graph")},
}};

}  // namespace
}  // namespace geodesic::straight_graph
