// The heat method as geometry-central has it.
#include <geometrycentral/surface/heat_method_distance.h>

#include "gc_mesh.h"
#include "peer.h"

namespace geodesic {
namespace {

namespace authors = geometrycentral::surface;

class GcHeat final : public Solver {
 public:
  // The tufted cover of the intrinsic Delaunay Laplacian is built of general meshes only.
  GcHeat(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        delaunay_(description.text("laplacian") == "intrinsic-delaunay"),
        surface_(mesh, !delaunay_),
        heat_(surface_.geometry, description.real("time"), delaunay_) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    const std::vector<authors::Vertex> sources = surface_.sources(query);
    authors::VertexData<double> found(surface_.mesh(), kInfinity);
    if (!sources.empty()) found = heat_.computeDistance(sources);
    surface_.answer(query, found, distances);
  }

  bool delaunay_;
  peer::GcMesh surface_;
  authors::HeatMethodDistanceSolver heat_;
};

const RegisterSolver<GcHeat> registered{{
    .name = "gc-heat",
    .family = "heat",
    .paper = "Crane, Weischedel, Wardetzky 2013, Geodesics in heat; Sharp, Crane 2020, A "
             "Laplacian for nonmanifold triangle meshes",
    .data_structure = "sparse factorisation",
    .time_complexity = "O(n^1.5)",
    .space_complexity = "O(n log n)",
    .propagation = "vertex",
    .exactness = Exactness::unbounded,
    .abilities = {.initial_distances = false},
    .remarks = peer::remarks("the heat method in geometry-central, factorised by CHOLMOD (GPL)"),
    .parameters = {choice_parameter("laplacian", {"cotangent", "intrinsic-delaunay"},
                                    "of the triangles, or of the intrinsic Delaunay edges of "
                                    "their tufted cover"),
                   real_parameter("time", 1, 1e-6, 1e6,
                                  "of the heat flow, by the square of the mean edge length")},
}};

}  // namespace
}  // namespace geodesic
