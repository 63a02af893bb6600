// MMP by Kirsanov with the repairs of geometry-central.
#include <geometrycentral/surface/exact_geodesics.h>

#include "gc_mesh.h"
#include "peer.h"

namespace geodesic {
namespace {

namespace authors = geometrycentral::surface;

class GcExact final : public Solver {
 public:
  GcExact(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), surface_(mesh), algorithm_(surface_.mesh, surface_.geometry) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    const std::vector<authors::Vertex> sources = surface_.sources(query);
    authors::VertexData<double> found(surface_.mesh, authors::GEODESIC_INF);
    if (!sources.empty()) {
      algorithm_.propagate(sources);
      found = algorithm_.getDistanceFunction();
    }
    surface_.answer(query, found, distances);
  }

  peer::GcMesh surface_;
  authors::GeodesicAlgorithmExact algorithm_;
};

const RegisterSolver<GcExact> registered{{
    .name = "gc-exact",
    .family = "MMP",
    .paper = "Surazhsky, Surazhsky, Kirsanov, Gortler, Hoppe 2005, Fast exact and approximate "
             "geodesics on meshes",
    .data_structure = "priority queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .abilities = {.initial_distances = false},
    .remarks = peer::remarks("Kirsanov's code in geometry-central"),
}};

}  // namespace
}  // namespace geodesic
