// A straight line between two vertices, as a path needs it.
#pragma once

#include <functional>

#include "solvers/core/window.h"

namespace geodesic::straight_graph {

struct Line {
  Index half_edge = kNone;  ///< through which it enters the face whose apex is its end
  double length = kInfinity;
  Point2 from = {0, 0};  ///< its beginning in the frame of that half-edge
};

/// Makes the links of a graph again that are no edges. Called as (Index v, visit); calls
/// visit(line) for the line of each link of v, and perhaps for others.
using FollowLinks = std::function<void(Index, const std::function<void(const Line&)>&)>;

}  // namespace geodesic::straight_graph
