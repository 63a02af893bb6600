// Points of the plane that surfaces are unfolded into, in extended precision.
#pragma once

#include <array>
#include <cmath>

#include "solvers/core/geometry.h"

namespace geodesic {

using Real = long double;

inline std::array<Real, 3> extended(const Vec3& p) { return {p[0], p[1], p[2]}; }

struct PlanePoint {
  Real x = 0;
  Real y = 0;
};

/// The length of a vector. std::hypot is not used: it is slow and handles squares beyond the range
/// of `Real`, but the squares of coordinates, which are doubles, are within that range.
inline Real norm(const PlanePoint& a) { return std::sqrt(a.x * a.x + a.y * a.y); }

inline Real distance(const PlanePoint& a, const PlanePoint& b) {
  return norm(PlanePoint{a.x - b.x, a.y - b.y});
}

/// Returns twice the signed area of the triangle a, b, c: positive if c lies to the left of a -> b.
inline Real turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace geodesic
