// Kirsanov's MMP in libigl.
//
// igl::exact_geodesic itself builds a mesh for every call and traces a path to every vertex for its
// distance. This adapter builds the mesh once and takes distances from the windows, with the
// authors' `best_source`.
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
  void run(const Start& start, std::span<double> distances) override {
    std::vector<authors::SurfacePoint> sources;
    for (const StartVertex& each : start.vertices)
      sources.emplace_back(&mesh_.vertices()[each.vertex]);
    const InternalQuery& query = start.query;
    std::vector<authors::SurfacePoint> stops;
    for (const InternalPoint& target : query.targets)
      if (query.stop_at_targets && target.is_vertex())
        stops.emplace_back(&mesh_.vertices()[target.vertex]);
    const bool all = stops.size() == query.targets.size();
    algorithm_->propagate(sources, authors::GEODESIC_INF, all ? &stops : nullptr);
    peer::answer(distances, authors::GEODESIC_INF, [&](Index v) {
      authors::SurfacePoint point(&mesh_.vertices()[v]);
      double d = authors::GEODESIC_INF;
      algorithm_->best_source(point, d);
      return d;
    });
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    peer::count<authors::Interval>(*algorithm_, recording);
  }

  std::vector<InternalPoint> trace_path(const InternalQuery& /*query*/,
                                        std::span<const double> /*distances*/,
                                        Index vertex) override {
    authors::SurfacePoint end(&mesh_.vertices()[vertex]);
    std::vector<authors::SurfacePoint> path;
    algorithm_->trace_back(end, path);
    std::vector<InternalPoint> points;
    for (auto point = path.rbegin(); point != path.rend(); ++point) points.push_back(own(*point));
    return points;
  }

  InternalPoint own(authors::SurfacePoint& point) {
    authors::MeshElementBase& element = *point.base_element();
    if (point.type() == authors::VERTEX) return InternalPoint(element.id());
    if (point.type() != authors::EDGE)
      throw std::invalid_argument("a path has a point inside a face");
    authors::Vertex &a = *element.adjacent_vertices()[0], &b = *element.adjacent_vertices()[1];
    return peer::on_edge(mesh(), a.id(), b.id(), point.distance(&a) / b.distance(&a));
  }

  authors::Mesh mesh_;
  std::optional<authors::GeodesicAlgorithmExact> algorithm_;  // set after the mesh is built
};

const RegisterSolver<LibiglExact> registered{
    peer::kirsanov("libigl-exact", "Kirsanov's code in libigl, asked for distances without paths")};

}  // namespace
}  // namespace geodesic
