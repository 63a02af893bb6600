// The heat method of geometry-central.
#include <geometrycentral/surface/heat_method_distance.h>

#include "gc_mesh.h"
#include "heat.h"

namespace geodesic {
namespace {

namespace authors = geometrycentral::surface;

class GcHeat final : public Solver {
 public:
  // The tufted cover of the intrinsic Delaunay Laplacian needs a general SurfaceMesh.
  GcHeat(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        delaunay_(peer::is_intrinsic_delaunay(description)),
        surface_(mesh, !delaunay_),
        heat_(surface_.geometry, description.real("time"), delaunay_) {}

 private:
  void run(const Start& start, std::span<double> distances) override {
    const std::vector<authors::Vertex> sources = surface_.sources(start);
    authors::VertexData<double> found(surface_.mesh(), kInfinity);
    if (!sources.empty()) found = heat_.computeDistance(sources);
    surface_.answer(start, found, distances);
  }

  bool delaunay_;
  peer::GcMesh surface_;
  authors::HeatMethodDistanceSolver heat_;
};

Description described() {
  Description heat = peer::heat_method(
      "gc-heat", "the heat method in geometry-central, factorised by CHOLMOD (GPL)",
      {peer::laplacian(peer::kCotangent), peer::heat_time()});
  heat.paper += "; Sharp, Crane 2020, A Laplacian for nonmanifold triangle meshes";
  return heat;
}

const RegisterSolver<GcHeat> registered{described()};

}  // namespace
}  // namespace geodesic
