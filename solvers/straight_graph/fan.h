// The fans of wedges that sources and targets send out.
#pragma once

#include <algorithm>

#include "solvers/core/query.h"

namespace geodesic::straight_graph {

/// Least angle of the wedges of a source or target, in radians: near it paths have few links, so
/// that errors do not cancel out.
inline constexpr double kFanAngle = 0.01;

/// Least angle of the wedges of each source of a query. All sources together unfold about as much
/// as one, as long as that is finer than the links of vertices.
/// @param angle the graph's
inline double angle_of_fan(const InternalQuery& query, double angle) {
  return std::min(angle, kFanAngle * static_cast<double>(query.sources.size()));
}

}  // namespace geodesic::straight_graph
