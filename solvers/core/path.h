// A path on the surface, found by any solver or tracer.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/query.h"

namespace geodesic {

/// A point of a path: its start, its end, a crossing of an edge or a vertex on the way. Vertex and
/// face numbers are those of the given mesh.
struct PathPoint {
  SurfacePoint at;
  Vec3 position = {};    ///< in space, in the mesh's unit of length
  double travelled = 0;  ///< length of the path from its source to this point
  /// The face that holds this point and the next one; the path is straight between them. kNone at
  /// the path's end, and where no face holds both: the path leaves the surface there.
  Index face = kNone;
};

/// A path, from its source to its end.
struct Path {
  Index source = kNone;           ///< index of its source in the query
  std::vector<PathPoint> points;  ///< at least one; a single point when the path ends in its source

  /// Length of the path. For a shortest path, the length plus the source's initial distance is the
  /// distance of the end, up to rounding.
  double length() const { return points.back().travelled; }
};

/// Continues a path by another one, which begins in its end.
void append(Path& path, const Path& next);

/// Returns the path that is straight between successive points.
/// @param points at least one; the first one is a source of the query
Path path_of_points(const Mesh& mesh, const InternalQuery& query,
                    std::span<const InternalPoint> points);

}  // namespace geodesic
