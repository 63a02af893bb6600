// The heat method as geometry-central has it.
#include <geometrycentral/surface/heat_method_distance.h>

#include <memory>
#include <optional>

#include "gc-exact/gc_mesh.h"
#include "peer.h"

namespace geodesic {
namespace {

namespace authors = geometrycentral::surface;

class GcHeat final : public Solver {
 public:
  GcHeat(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), surface_(mesh), asked_(&surface_.mesh) {
    const bool delaunay = description.text("laplacian") == "intrinsic-delaunay";
    if (delaunay) {  // the tufted cover is built of a general mesh only
      general_ = surface_.mesh.copyToSurfaceMesh();
      general_geometry_ = surface_.geometry.reinterpretTo(*general_);
      asked_ = general_.get();
    }
    heat_.emplace(delaunay ? *general_geometry_ : surface_.geometry, description.real("time"),
                  delaunay);
  }

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    std::vector<authors::Vertex> sources = surface_.sources(query);
    for (authors::Vertex& source : sources) source = asked_->vertex(source.getIndex());
    authors::VertexData<double> found(*asked_, kInfinity);
    if (!sources.empty()) found = heat_->computeDistance(sources);
    surface_.answer(query, found, distances);
  }

  peer::GcMesh surface_;
  std::unique_ptr<authors::SurfaceMesh> general_;
  std::unique_ptr<authors::VertexPositionGeometry> general_geometry_;
  authors::SurfaceMesh* asked_;  // the mesh that the method works on
  std::optional<authors::HeatMethodDistanceSolver> heat_;
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
