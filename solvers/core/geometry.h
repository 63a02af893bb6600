// Points, vectors and triangles as plain data, from which meshes are built.
#pragma once

#if __cplusplus < 202002L
#error "geodesic-bench needs C++20: compile with -std=c++20"
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace geodesic {

/// Index of a vertex, half-edge or face; 32 bits bound a mesh to about 1.4 * 10^9 faces.
using Index = std::uint32_t;

/// "No such element": the twin of a boundary half-edge, an unset vertex.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point or vector in space, in the unit of length of the file it came from.
using Vec3 = std::array<double, 3>;

inline Vec3 add(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
template <class Number>
std::array<Number, 3> subtract(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 scale(double factor, const Vec3& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
template <class Number>
Number dot(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Euclidean length.
template <class Number>
Number norm(const std::array<Number, 3>& a) {
  return std::sqrt(dot(a, a));
}
inline bool is_finite(const Vec3& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// Three vertex indices in counter-clockwise order seen from outside.
using Triangle = std::array<Index, 3>;

/// Triangles that share vertices by index; their topology is arbitrary.
struct TriangleSoup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// By vertex: the one that stands for it in the triangles, itself if it was not joined to another
  /// one. Both names mean the same point, with one distance. Empty when no vertices were joined.
  std::vector<Index> joined_to = {};
  /// By triangle: whether it only has a number, and is no face. Empty when all triangles are faces.
  std::vector<bool> left_out = {};

  bool is_face(Index f) const { return left_out.empty() || !left_out[f]; }
  bool is_joined(Index v) const { return !joined_to.empty() && joined_to[v] != v; }
};

/// The smallest axis-parallel box around some points; without points, low is above high.
struct Box {
  Vec3 low{kInfinity, kInfinity, kInfinity};
  Vec3 high{-kInfinity, -kInfinity, -kInfinity};

  void include(const Vec3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }

  /// Half the longest side, 0 without points. The whole side of a finite box may overflow.
  double half_extent() const {
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, high[k] / 2 - low[k] / 2);
    return extent;
  }
};

inline Box box_around(std::span<const Vec3> positions) {
  Box box;
  for (const Vec3& p : positions) box.include(p);
  return box;
}

}  // namespace geodesic
