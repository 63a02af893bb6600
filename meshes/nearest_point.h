// The point of a surface that is nearest to a place in space.
#pragma once

#include "solvers/core/mesh.h"
#include "solvers/core/surface_point.h"

namespace geodesic {

struct NearestPoint {
  SurfacePoint at;
  double distance;  ///< through space, in the mesh's unit of length
};

/// Looks at every face: time is linear in the mesh. Of several nearest points, that of the face of
/// least number in the mesh's internal numbers; isolated vertices are no part of the surface.
/// @throws std::invalid_argument when the place is not finite, or the mesh has no face
NearestPoint nearest_point(const Mesh& mesh, const Vec3& place);

}  // namespace geodesic
