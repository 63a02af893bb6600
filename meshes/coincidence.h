// Vertices that lie at the same place, or nearly.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Pairs of vertices, the lesser number first, that join the vertices of each set: two vertices are
/// in one set if a chain of vertices leads from one to the other in steps of the distance at most.
/// A set of n vertices has n - 1 pairs. They are ordered by their second vertex.
struct Coincidences {
  std::vector<std::pair<Index, Index>> same;  ///< at the same place; -0 equals 0
  std::vector<std::pair<Index, Index>> near;  ///< at different places
};

/// Finds them in expected linear time, with hashed cells of the distance's size: many vertices in
/// one cell are in one set, or share it with few others.
/// @param used one flag per vertex; others are left out. The positions of used ones are finite.
/// @param distance in the mesh's unit of length, finite, not negative; 0 finds `same` only
Coincidences find_coincidences(std::span<const Vec3> positions, const std::vector<bool>& used,
                               double distance);

}  // namespace geodesic
