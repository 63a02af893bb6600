// The box around a mesh.
#pragma once

#include <algorithm>
#include <span>

#include "solvers/core/geometry.h"

namespace geodesic {

/// The smallest box along the axes around some points; low is above high when there are none.
struct Box {
  Vec3 low{kInfinity, kInfinity, kInfinity};
  Vec3 high{-kInfinity, -kInfinity, -kInfinity};

  /// Half the longest side, 0 without points. Halved, so that that of any finite box is finite.
  double half_extent() const {
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, high[k] / 2 - low[k] / 2);
    return extent;
  }
};

inline Box box_around(std::span<const Vec3> positions) {
  Box box;
  for (const Vec3& p : positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  }
  return box;
}

}  // namespace geodesic
