// Isolines of a distance field: the lines of equal distance on the surface.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/path.h"

namespace geodesic {

/// One line on which the distance, interpolated linearly along the edges, is the level. It is
/// straight in each face. The true line consists of arcs: this one is off by up to the square of
/// the edge length over their radius, and cuts off corners inside a face.
struct Isoline {
  double level = 0;     ///< a distance, in the mesh's unit of length
  bool closed = false;  ///< the last point is the first one again
  /// At least two, on edges and at vertices, each with the face up to the next one. Smaller
  /// distances lie on the left, seen from outside, in the line's face of least number.
  std::vector<PathPoint> points;

  double length() const { return points.back().travelled; }
};

/// Most levels that equal_levels returns.
inline constexpr Index kMostLevels = 10000;

/// Levels that cut the range from 0 to the largest finite distance into `count` + 1 equal steps,
/// without its ends. None when no distance is finite and above 0.
/// @throws std::invalid_argument for a count that is 0 or more than kMostLevels
std::vector<double> equal_levels(std::span<const double> distances, Index count);

/// Returns the isolines of each level, in the order of the levels, then of their face of least
/// number. They have external numbers. Each level takes a time linear in the number of faces.
///
/// A vertex at the level counts as farther: a line passes it, or turns round at it, and has neither
/// a gap nor a branch there; one that would be this vertex alone is left out. A line closes, or
/// ends at a boundary, at an edge of more than two faces, or at a face with an unreached vertex. It
/// crosses an edge of two faces that have it in one direction if paths of the mesh do.
/// @param distances one for each vertex; infinite where it is not reached
/// @param levels finite distances above 0
/// @throws std::invalid_argument for another level, for another number of distances, and for a
///         distance that is negative or not a number
std::vector<Isoline> isolines(const Mesh& mesh, std::span<const double> distances,
                              const std::vector<double>& levels);

}  // namespace geodesic
