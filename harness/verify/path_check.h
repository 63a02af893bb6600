// Checks that a path is one of the mesh's shortest paths. The checks use only the positions, in
// extended precision, and no data of the code that traced the path.
#pragma once

#include "harness/verify/distance_check.h"
#include "solvers/paths/paths.h"

namespace geodesic::harness {

/// Checks that the path leads from its source to `end`, that each piece lies in the face it names,
/// and that its length agrees with the distance of `end` and with the `travelled` of its points.
/// @param distance of `end`, for the query that the path answers
Finding check_path(const Mesh& mesh, const Query& query, const SurfacePoint& end, double distance,
                   const Path& path, const Tolerance& tolerance = {});

/// Checks that the unfolded path is straight between the vertices it runs through: it leaves the
/// line by at most the tolerance, relative to the line's length, plus the rounding of its positions
/// on edges. At these vertices the angle on both sides must be at least pi: cutting the corner must
/// save no more than the tolerance, relative to the distance. At a vertex where no path may bend,
/// one side must be straight; the angle on the other side may be smaller by the rounding of
/// coordinates. Corners of faces without area have no angles and are not checked.
/// @param path that check_path has accepted
Finding check_straight(const Mesh& mesh, const Path& path, const Tolerance& tolerance = {});

}  // namespace geodesic::harness
