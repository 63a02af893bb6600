// Small surfaces for tests of several folders.
#pragma once

#include <cmath>
#include <numbers>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A closed fan of `count` faces around vertex 0 at the origin. The heights of the other vertices
/// alternate between `even` and `odd`.
inline TriangleSoup fan(Index count, double even, double odd) {
  TriangleSoup soup{{{0, 0, 0}}, {}};
  for (Index i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    soup.positions.push_back({std::cos(angle), std::sin(angle), i % 2 == 0 ? even : odd});
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  return soup;
}

/// A closed band of `count` quadrilaterals, two triangles each. A Moebius strip turns over once.
inline TriangleSoup band(Index count, bool moebius) {
  TriangleSoup soup;
  for (Index i = 0; i < count; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double angle = 2 * std::numbers::pi * i / count, tilt = moebius ? angle / 2 : 0;
      const double radius = 3 + side * std::cos(tilt);
      soup.positions.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), side * std::sin(tilt)});
    }
    const Index next = 2 * ((i + 1) % count);
    const Index turned = moebius && i + 1 == count ? 1 : 0;
    const Index low = next + turned, high = next + 1 - turned;
    soup.triangles.insert(soup.triangles.end(), {{2 * i, low, high}, {2 * i, high, 2 * i + 1}});
  }
  return soup;
}

}  // namespace geodesic
