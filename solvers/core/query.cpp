#include "solvers/core/query.h"

#include <cmath>

namespace geodesic {

std::vector<Index> Query::source_vertices(const Mesh& mesh) const {
  std::vector<Index> vertices;
  for (const Source& source : sources) {
    vertices.push_back(source.at.is_vertex() ? source.at.vertex : mesh.origin(3 * source.at.face));
  }
  return vertices;
}

StopRule::StopRule(const Mesh& mesh, const Query& query, std::span<const double> distances)
    : limit_(query.limit), stops_(query.stop_at_targets), distances_(distances) {
  if (!stops_) return;
  for (const SurfacePoint& target : query.targets) {
    if (target.is_vertex()) {
      bounds_.push_back({{target.vertex, target.vertex, target.vertex}, {}});
      continue;
    }
    Bound bound{};
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * target.face + k;  // leaves corner k
      const Point2 at = in_frame(mesh, target, h);
      bound.corners[k] = mesh.origin(h);
      bound.rest[k] = norm(at);
    }
    bounds_.push_back(bound);
  }
}

double StopRule::farthest() const {
  if (!stops_) return limit_;
  double farthest = 0;
  for (const Bound& each : bounds_) farthest = std::max(farthest, bound(each));
  return std::min(limit_, farthest);
}

}  // namespace geodesic
