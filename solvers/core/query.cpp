#include "solvers/core/query.h"

#include <cmath>

namespace geodesic {

InternalQuery in_internal_numbers(const Mesh& mesh, const Query& query) {
  InternalQuery own{.sources = {}, .limit = query.limit, .stop_at_targets = query.stop_at_targets};
  for (const auto& [at, distance] : query.sources) {
    own.sources.push_back({in_internal_numbers(mesh, at), distance});
  }
  for (const SurfacePoint& target : query.targets) {
    own.targets.push_back(in_internal_numbers(mesh, target));
  }
  return own;
}

StopRule::StopRule(const Mesh& mesh, const InternalQuery& query, std::span<const double> distances)
    : limit_(query.limit), stops_(query.stop_at_targets), distances_(distances) {
  if (!stops_) return;
  for (const InternalPoint& target : query.targets) {
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
