// Paths through several points in their order, open or closed.
#pragma once

#include <span>

#include "solvers/core/path.h"
#include "solvers/core/solver.h"

namespace geodesic {

struct ThroughOptions {
  bool closed = false;  ///< the last point is joined to the first one
  /// The locally shortest curve in the class of the joined pieces, with the first and the last
  /// point in place unless it is closed (straighten.h). It need not pass the other points.
  bool straighten = false;
};

/// Returns the shortest paths between successive points, joined, with one solve a piece. A closed
/// one ends in its first point again.
/// @param solver a solver on this mesh that supports paths (Abilities::paths) and these points
/// @param points at least two; they may repeat
/// @return its source is 0
/// @throws std::invalid_argument for fewer points, a point that is not of this mesh, a piece over
///         which no path leads, and the reasons of `straightened`
Path path_through(Solver& solver, const Mesh& mesh, std::span<const SurfacePoint> points,
                  const ThroughOptions& options = {});

}  // namespace geodesic
