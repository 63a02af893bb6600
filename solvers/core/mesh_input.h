// The input checks of Mesh's constructor, for code that stores the input and builds the mesh later.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Least and greatest extent (the longest side of the bounding box) of a mesh that solvers accept,
/// besides the extent 0 of a single point. Products of four lengths and their differences then stay
/// within the range and precision of a double. Approximate solvers store small differences as
/// floats: 1e-18 times a length stays within those of a float.
inline constexpr double kLeastExtent = 1e-20, kGreatestExtent = 1e20;

/// @throws std::invalid_argument for an extent outside these bounds
void check_extent(std::span<const Vec3> positions);

/// @param left_out as in TriangleSoup: such a triangle is not checked
/// @throws std::invalid_argument for the reasons of Mesh's constructor
void check_mesh_input(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                      const std::vector<bool>& left_out = {});

/// Checks that a TriangleSoup's other members fit its positions and triangles.
/// @throws std::invalid_argument for members of another length, a joined vertex that stands for
///         another one or that a face names, and a number that the mesh does not have
void check_names(std::size_t vertices, std::span<const Triangle> triangles,
                 std::span<const Index> joined_to, const std::vector<bool>& left_out);

}  // namespace geodesic
