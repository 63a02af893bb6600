// geometry-central's paths along edges that are shortened by edge flips.
#include <geometrycentral/surface/flip_geodesics.h>
#include <geometrycentral/surface/mesh_graph_algorithms.h>

#include <memory>

#include "gc_mesh.h"

// A part of geometry-central that paths do not use and that would need its file readers.
geometrycentral::surface::CommonSubdivision::CommonSubdivision(ManifoldSurfaceMesh& a,
                                                               ManifoldSurfaceMesh& b)
    : meshA(a), meshB(b) {
  throw std::logic_error("gc-flip has no common subdivisions");
}

namespace geodesic {
namespace {

namespace authors = geometrycentral::surface;

class GcFlip final : public Solver {
 public:
  GcFlip(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        surface_(mesh, true),
        network_(dynamic_cast<authors::ManifoldSurfaceMesh&>(surface_.mesh()), surface_.geometry,
                 {}) {
    network_.supportRewinding = true;
    network_.posGeom = &surface_.geometry;
  }

 private:
  // Distances along edges, because geometry-central has no distances of shortened paths.
  void run(const Start& start, std::span<double> distances) override {
    authors::VertexData<double> found(surface_.mesh(), kInfinity);
    for (const authors::Vertex source : surface_.sources(start)) {
      for (const auto& [vertex, distance] :
           authors::vertexDijkstraDistanceWithinRadius(surface_.geometry, source, kInfinity)) {
        found[vertex] = std::min(found[vertex], distance);
      }
    }
    surface_.answer(start, found, distances);
  }

  std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                        std::span<const double> /*distances*/,
                                        Index vertex) override {
    if (query.sources.size() > 1) throw std::invalid_argument("gc-flip: one source only");
    const Index source = query.sources.front().at.vertex;
    if (source == vertex) return {InternalPoint(source)};
    network_.reinitializePath({authors::shortestEdgePath(surface_.geometry, surface_.vertex(source),
                                                         surface_.vertex(vertex))});
    network_.addAllWedgesToAngleQueue();
    network_.iterativeShorten();
    return surface_.points(mesh(), network_.getPathPolyline().front());
  }

  peer::GcMesh surface_;
  authors::FlipEdgeNetwork network_;
};

const RegisterSolver<GcFlip> registered{{
    .name = "gc-flip",
    .family = "edge flips",
    .paper =
        "Sharp, Crane 2020, You can find geodesic paths in triangle meshes by just flipping edges",
    .exactness = Exactness::upper_bound,
    .abilities = {.multiple_sources = false,
                  .initial_distances = false,
                  .non_manifold_vertices = false,
                  .traces = true},
    .remarks = peer::remarks("geometry-central's paths by edge flips; distances are along edges"),
}};

}  // namespace
}  // namespace geodesic
