// Traces shortest paths from exact distances.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic {

/// A crossing of a path and an edge.
struct EdgeCrossing {
  Index half_edge;   ///< half-edge whose face the path enters
  double position;   ///< distance from its origin, in the mesh's unit of length
  double travelled;  ///< length of the piece up to this crossing
};

/// A part of a path that is straight when the faces it crosses are unfolded.
struct StraightPiece {
  Index from, to;  ///< vertices
  double length;
  std::vector<EdgeCrossing> crossings;  ///< in order; empty if the piece is an edge
};

/// Returns a shortest path from the nearest source to `target`, source first. It is straight except
/// at pseudo-sources and other vertices on it. Vertices and half-edges have internal numbers.
/// @param distances the exact distances of this query
/// @return empty if the target is a source that no other path reaches sooner, if it is unreachable,
///         and if the distances belong to no path (relative error above 1e-9)
std::vector<StraightPiece> shortest_path(const Mesh& mesh, std::span<const InternalSource> sources,
                                         std::span<const double> distances, Index target);

}  // namespace geodesic
