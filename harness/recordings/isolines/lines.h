// From the arcs of an isoline in a face, and its crossings of the edges, to polylines.
#pragma once

#include <span>
#include <vector>

#include "harness/recordings/isolines/arcs.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// A point of an isoline in the frame of its face.
struct LinePoint {
  Point2 at;
  Index crossing = kNone;  ///< index of the crossing that it is; none inside the face
};

/// Where an isoline crosses the border of a face.
struct BorderCrossing {
  Point2 at;
  bool begins;  ///< clockwise about the source the isoline enters the face here, else it leaves it
};

using Line = std::vector<LinePoint>;

/// Joins arcs to lines. Each begins and ends at a crossing, or is closed: its last point is then
/// its first. All crossings are used, but for those that touch the face in a point.
/// @param size length of the longest edge of the face
/// @param chord_error how far a line may be from its arcs; lines have no more points than that
/// takes
/// @param lines overwritten
void join_arcs(std::span<const Arc> arcs, std::span<const BorderCrossing> crossings, double size,
               double chord_error, std::vector<Line>& lines);

}  // namespace geodesic::harness
