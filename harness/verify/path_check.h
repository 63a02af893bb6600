// Whether a path is one of the mesh's shortest paths: judged from the positions alone, in extended
// precision, and with no help of what traced it.
#pragma once

#include "harness/verify/distance_check.h"
#include "solvers/paths/paths.h"

namespace geodesic::harness {

/// The path leads over the surface from the source it names to `end`, point by point in the faces
/// it names, and is as long as the end's distance and its own `travelled` say.
/// @param query that the path answers, of which `distance` is the distance of `end`
Finding check_path(const Mesh& mesh, const Query& query, const SurfacePoint& end, double distance,
                   const Path& path, const Tolerance& tolerance = {});

/// Between the vertices it runs through the path is straight once the faces it crosses are
/// unfolded: it leaves the line by no more than the tolerance, relative to the line's length, and
/// what rounding does to shares of the edges it crosses. At
/// these vertices it has an angle of at least pi on both sides: to cut the corner saves no more
/// than the tolerance, relative to the distance. Where no path may bend, it is straight on one
/// side: on the other one the angle may be smaller by what rounding does to coordinates. Corners of
/// faces without area, which have no angles, are passed over.
/// @param path that check_path has accepted
Finding check_straight(const Mesh& mesh, const Path& path, const Tolerance& tolerance = {});

}  // namespace geodesic::harness
