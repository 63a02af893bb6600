// MMP by Kirsanov with the repairs of geometry-central.
#include <geometrycentral/surface/exact_geodesics.h>
#include <geometrycentral/surface/manifold_surface_mesh.h>
#include <geometrycentral/surface/vertex_position_geometry.h>

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
    std::vector<authors::Vertex> sources;
    for (const Source& source : query.sources)
      sources.push_back(surface_.mesh.vertex(source.vertex));
    algorithm_.propagate(sources);
    const authors::VertexData<double> found = algorithm_.getDistanceFunction();
    for (Index v = 0; v < distances.size(); ++v) {
      if (found[v] < authors::GEODESIC_INF) distances[v] = found[v];
    }
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
