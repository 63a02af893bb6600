// The geodesic graph of Nazzaro, Puppo and Pellacini, in the Yocto/GL of its authors.
#include <yocto_shape.h>

#include <algorithm>

#include "peer.h"

namespace geodesic {
namespace {

class GeodesicGraph final : public Solver {
 public:
  GeodesicGraph(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    std::vector<yocto::vec3f> points;
    for (const Vec3& p : mesh.positions())
      points.emplace_back(static_cast<float>(p[0]), static_cast<float>(p[1]),
                          static_cast<float>(p[2]));
    std::vector<yocto::vec3i> faces;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [a, b, c] = mesh.triangle(f);
      faces.emplace_back(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
    }
    graph_ = yocto::make_geodesic_solver(faces, yocto::face_adjacencies(faces), points);
  }

 private:
  void run(const Start& start, std::span<double> distances) override {
    std::vector<float> found(distances.size(), yocto::flt_max);
    std::vector<int> sources;
    for (const StartVertex& each : start.vertices) {
      float& initial = found[each.vertex];
      initial = std::min(initial, static_cast<float>(each.distance));
      sources.push_back(static_cast<int>(each.vertex));
    }
    yocto::update_geodesic_distances(found, graph_, sources);
    peer::answer(distances, yocto::flt_max, [&](Index v) { return found[v]; });
  }

  yocto::geodesic_solver graph_;
};

const RegisterSolver<GeodesicGraph> registered{{
    .name = "geodesic-graph",
    .family = "Dijkstra",
    .paper = "Nazzaro, Puppo, Pellacini 2022, geoTangle: Interactive design of geodesic tangle "
             "patterns on surfaces",
    .exactness = Exactness::unbounded,
    .remarks = peer::remarks("the authors' code, in single precision; a link across an edge is a "
                             "line that may miss the edge, so that distances may be too short"),
}};

}  // namespace
}  // namespace geodesic
