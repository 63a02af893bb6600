// Kirsanov's MMP, as repaired in geometry-central.
#include <geometrycentral/surface/exact_geodesics.h>

#include <algorithm>

#include "gc_mesh.h"
#include "kirsanov.h"

namespace geodesic {
namespace {

namespace authors = geometrycentral::surface;

// Makes the protected counters accessible.
struct Algorithm : authors::GeodesicAlgorithmExact {
  using GeodesicAlgorithmExact::GeodesicAlgorithmExact;
  using GeodesicAlgorithmExact::m_iterations;
  using GeodesicAlgorithmExact::m_queue_max_size;
};

class GcExact final : public Solver {
 public:
  GcExact(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        surface_(mesh, true),
        algorithm_(surface_.mesh(), surface_.geometry) {}

 private:
  void run(const Start& start, std::span<double> distances) override {
    const std::vector<authors::Vertex> sources = surface_.sources(start);
    authors::VertexData<double> found(surface_.mesh(), authors::GEODESIC_INF);
    if (!sources.empty()) {
      algorithm_.propagate(sources, authors::GEODESIC_INF, surface_.stops(start.query));
      found = algorithm_.getDistanceFunction();
    }
    surface_.answer(start, found, distances);
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    if (!surface_.sources(start).empty()) {
      peer::count<authors::Interval>(algorithm_, recording);
    }
  }

  std::vector<InternalPoint> trace_path(const InternalQuery& /*query*/,
                                        std::span<const double> /*distances*/,
                                        Index vertex) override {
    std::vector<authors::SurfacePoint> path = algorithm_.traceBack(surface_.vertex(vertex));
    std::ranges::reverse(path);
    return surface_.points(mesh(), path);
  }

  peer::GcMesh surface_;
  Algorithm algorithm_;
};

const RegisterSolver<GcExact> registered{
    peer::kirsanov("gc-exact", "Kirsanov's code in geometry-central")};

}  // namespace
}  // namespace geodesic
