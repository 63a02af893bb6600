// A path over the surface, whoever found it.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/query.h"

namespace geodesic {

/// A point of a path: its beginning, its end, where it crosses an edge or passes through a vertex.
/// Numbers of vertices and faces are those that the mesh was given.
struct PathPoint {
  SurfacePoint at;
  Vec3 position = {};    ///< in space, in the mesh's unit of length
  double travelled = 0;  ///< along the path, from its source to here
  /// The face, with this point and the next one on it, between which the path is straight; kNone
  /// at the path's end, and where no face has both: the path leaves the surface there.
  Index face = kNone;
};

/// A path, from its source to its end.
struct Path {
  Index source = kNone;           ///< the query's source it comes from, by its place in the query
  std::vector<PathPoint> points;  ///< at least one, which is a source that the path ends in itself

  /// Of the path. Of a shortest path, with the source's initial distance, it is the end's distance,
  /// up to rounding.
  double length() const { return points.back().travelled; }
};

/// The path that is straight between these points.
/// @param points at least one; the path's source is that of the query in the first one
Path path_through(const Mesh& mesh, const InternalQuery& query,
                  std::span<const InternalPoint> points);

}  // namespace geodesic
