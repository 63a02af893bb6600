// Shortest paths themselves, traced back from distances that are known to be right.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic {

/// Where a path crosses an edge.
struct EdgeCrossing {
  Index half_edge;   ///< the one whose face the path enters
  double position;   ///< from its origin, in the mesh's unit of length
  double travelled;  ///< of the piece, up to here
};

/// A part of a path that is straight when the faces it crosses are unfolded.
struct StraightPiece {
  Index from, to;  ///< vertices
  double length;
  std::vector<EdgeCrossing> crossings;  ///< in order; none when the piece is an edge
};

/// A shortest path from the nearest source to `target`, source first. It is straight but at
/// vertices: pseudo-sources, or others that it runs through by chance.
/// Vertices and half-edges go by the mesh's internal numbers.
/// @param distances of this query, exact
/// @return empty when the target is a source that no other path reaches sooner, when it is
///         unreachable, and when the distances belong to no path (relative error above 1e-9)
std::vector<StraightPiece> shortest_path(const Mesh& mesh, std::span<const InternalSource> sources,
                                         std::span<const double> distances, Index target);

}  // namespace geodesic
