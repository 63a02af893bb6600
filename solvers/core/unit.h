// Meshes whose unit of length takes squares and fourth powers of lengths out of a double's range.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A unit of length in which a mesh is of ordinary extent: a power of two of the mesh's own unit,
/// so that converting changes no bit of a mantissa.
class Unit {
 public:
  /// 1 for a mesh whose extent, the longest side of its box, lies between 2^-128 and 2^128 (about
  /// 1e-38 and 1e38): squares, products of four lengths and their differences then stay within
  /// range. Otherwise the unit in which the extent lies between 1 and 2.
  /// @throws std::invalid_argument when the extent is not 0 and beyond 1e-289 or 1e289, where
  ///         distances themselves leave the range of a double or its precision
  static Unit of(std::span<const Vec3> positions);

  bool is_one() const { return exponent_ == 0; }
  /// A length of the mesh, measured in this unit.
  double in_unit(double length) const { return std::ldexp(length, -exponent_); }
  std::vector<Vec3> in_unit(std::span<const Vec3> positions) const;
  /// A length measured in this unit, in that of the mesh.
  double in_mesh(double length) const { return std::ldexp(length, exponent_); }

 private:
  int exponent_ = 0;
};

}  // namespace geodesic
