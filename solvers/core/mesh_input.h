// What the constructor of Mesh refuses, for who keeps its input and builds the mesh later.
#pragma once

#include <span>

#include "solvers/core/geometry.h"

namespace geodesic {

/// The extents of meshes, the longest side of their box, that solvers take, besides 0 of a mesh
/// that is a point. Products of four lengths and their differences stay within the range and
/// precision of a double, and a billionth of a billionth of a length that of a float, as which
/// approximate solvers store small differences.
inline constexpr double kLeastExtent = 1e-20, kGreatestExtent = 1e20;

/// @throws std::invalid_argument for an extent beyond these
void check_extent(std::span<const Vec3> positions);

/// @throws std::invalid_argument as the constructor of Mesh does
void check_mesh_input(std::span<const Vec3> positions, std::span<const Triangle> triangles);

}  // namespace geodesic
