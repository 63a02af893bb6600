// Points of a plane in extended precision: what surfaces unroll to.
#pragma once

#include <cmath>

namespace geodesic::generators {

struct PlanePoint {
  long double x = 0;
  long double y = 0;
};

inline long double distance(const PlanePoint& a, const PlanePoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Twice the signed area of the triangle a, b, c: positive when c lies to the left of a -> b.
inline long double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace geodesic::generators
