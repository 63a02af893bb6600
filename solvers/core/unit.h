// Meshes whose unit of length takes squares and fourth powers of lengths out of a double's range.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// 0 for a mesh of ordinary extent, 2^-128 to 2^128 (about 1e-38 to 1e38) along the longest axis of
/// its box: squares, products of four lengths and their differences stay within range by themselves
/// then. Otherwise the exponent e for which the extent lies between 2^e and 2^(e + 1): measured in
/// units of 2^e, which changes no bit of a mantissa, the mesh is an ordinary one.
/// @throws std::invalid_argument when e is beyond -960 or 960, where distances themselves leave the
///         range of a double or its precision
int unit_exponent(std::span<const Vec3> positions);

/// The positions times 2^exponent.
std::vector<Vec3> scaled(std::span<const Vec3> positions, int exponent);

}  // namespace geodesic
