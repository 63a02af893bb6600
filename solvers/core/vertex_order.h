// Numbering vertices so that neighbours on the surface are neighbours in memory.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// All vertices in the order in which a space-filling curve meets them (Morton 1966, "A computer
/// oriented geodetic data base"), those of one cell of 1/1024 of the bounding box in their given
/// order. Time and memory are linear: a radix sort.
/// @param positions finite
std::vector<Index> order_along_curve(std::span<const Vec3> positions);

/// Faces in the order of their least vertex, those of one vertex in their given order; linear.
std::vector<Index> order_by_least_vertex(std::span<const Triangle> triangles, Index vertices);

}  // namespace geodesic
