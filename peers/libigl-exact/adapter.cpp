// MMP by Kirsanov, as libigl has it.
//
// igl::exact_geodesic itself builds a mesh for every call and traces a path to every vertex for its
// distance. Here the mesh is built once, and distances come from the windows: what its authors'
// `best_source` does.
#include <igl/exact_geodesic.h>

#include <optional>

#include "kirsanov.h"

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
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    std::vector<authors::SurfacePoint> sources;
    for (const Source& source : query.sources)
      sources.emplace_back(&mesh_.vertices()[source.at.vertex]);
    algorithm_->propagate(sources);
    peer::answer(distances, authors::GEODESIC_INF, [&](Index v) {
      authors::SurfacePoint point(&mesh_.vertices()[v]);
      double d = authors::GEODESIC_INF;
      algorithm_->best_source(point, d);
      return d;
    });
    peer::count<authors::Interval>(*algorithm_, recording);
  }

  authors::Mesh mesh_;
  std::optional<authors::GeodesicAlgorithmExact> algorithm_;  // once the mesh is built
};

const RegisterSolver<LibiglExact> registered{
    peer::kirsanov("libigl-exact", "Kirsanov's code in libigl, asked for distances without paths")};

}  // namespace
}  // namespace geodesic
