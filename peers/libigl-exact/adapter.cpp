// MMP by Kirsanov, as libigl has it.
//
// igl::exact_geodesic itself builds a mesh for every call and traces a path to every vertex for its
// distance. Here the mesh is built once, and distances come from the windows: what its authors'
// `best_source` does.
#include <igl/exact_geodesic.h>

#include <optional>

#include "peer.h"

namespace geodesic {
namespace {

namespace authors = igl::geodesic;

class LibiglExact final : public Solver {
 public:
  LibiglExact(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    std::vector<double> points = peer::coordinates(mesh);
    std::vector<int> faces = peer::corners<int>(mesh);
    mesh_.initialize_mesh_data(points, faces);
    algorithm_.emplace(&mesh_);
  }

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    std::vector<authors::SurfacePoint> sources;
    for (const Source& source : query.sources)
      sources.emplace_back(&mesh_.vertices()[source.at.vertex]);
    algorithm_->propagate(sources);
    for (Index v = 0; v < distances.size(); ++v) {
      authors::SurfacePoint point(&mesh_.vertices()[v]);
      double d = authors::GEODESIC_INF;
      algorithm_->best_source(point, d);
      if (d < authors::GEODESIC_INF) distances[v] = d;
    }
  }

  authors::Mesh mesh_;
  std::optional<authors::GeodesicAlgorithmExact> algorithm_;  // once the mesh is built
};

// The authors drop windows of less than this share of their edge (SMALLEST_INTERVAL_RATIO). The
// algorithm is exact; what they state no other bound of is held to this one.
constexpr double kDropped = 1e-6;

const RegisterSolver<LibiglExact> registered{{
    .name = "libigl-exact",
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
    .remarks = peer::remarks("Kirsanov's code in libigl, asked for distances without paths"),
}};

}  // namespace
}  // namespace geodesic
