// Planar sectors around one vertex: cones and saddles whose distances are those of an unrolled fan.
#pragma once

#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A closed fan: sector i is the planar triangle from the origin between directions i and i + 1
/// (the last one between the last and the first), cut into `rings`^2 similar triangles.
///
/// Vertex 0 is the origin; ring r = 1 ... rings follows with r vertices a sector: its vertex
/// i r + k lies k / r of the way from r / rings * directions[i] to r / rings * directions[i + 1].
TriangleSoup sector_fan(const std::vector<Vec3>& directions, Index rings);

}  // namespace geodesic
