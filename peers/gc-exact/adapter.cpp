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
      : Solver(mesh, description),
        surface_(mesh, true),
        algorithm_(surface_.mesh(), surface_.geometry) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    const std::vector<authors::Vertex> sources = surface_.sources(query);
    authors::VertexData<double> found(surface_.mesh(), authors::GEODESIC_INF);
    if (!sources.empty()) {
      algorithm_.propagate(sources);
      found = algorithm_.getDistanceFunction();
    }
    surface_.answer(query, found, distances);
  }

  peer::GcMesh surface_;
  authors::GeodesicAlgorithmExact algorithm_;
};

// The authors drop windows of less than this share of their edge (SMALLEST_INTERVAL_RATIO). The
// algorithm is exact; what they state no other bound of is held to this one.
constexpr double kDropped = 1e-6;

const RegisterSolver<GcExact> registered{{
    .name = "gc-exact",
    .family = "MMP",
    .paper = "Surazhsky, Surazhsky, Kirsanov, Gortler, Hoppe 2005, Fast exact and approximate "
             "geodesics on meshes",
    .data_structure = "priority queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .exactness = Exactness::bounded,
    .error_bound = [](const Description&) { return kDropped; },
    .abilities = {.initial_distances = false},
    .remarks = peer::remarks("Kirsanov's code in geometry-central"),
}};

}  // namespace
}  // namespace geodesic
