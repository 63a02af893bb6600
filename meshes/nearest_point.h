// Finds the point of a surface that is nearest to a point in space.
#pragma once

#include <string>

#include "solvers/core/mesh.h"
#include "solvers/core/surface_point.h"

namespace geodesic {

struct NearestPoint {
  SurfacePoint at;
  double distance;  ///< through space, in the mesh's unit of length
};

/// Visits every face: the time is linear in the mesh. If several points are nearest, returns that
/// of the face with the least internal number. Isolated vertices are not part of the surface.
/// @throws std::invalid_argument if the place is not finite, or the mesh has no face
NearestPoint nearest_point(const Mesh& mesh, const Vec3& place);

/// "is 5 from the surface, whose nearest point is taken; ..." for a place that was probably meant
/// in other units or axes: farther than 1% of the mesh's longest side. Empty for a nearer one.
/// @param distance of the place from the surface
std::string remark_if_far(const Mesh& mesh, double distance);

}  // namespace geodesic
