// Strategy II: one angle, two sides (thesis section 5.1.2).
//
// The shortest path from the windows of an edge to the opposite vertex, the apex, separates them:
// what crosses that path inside the face is no geodesic. Windows left of it go to the left edge,
// right of it to the right edge, and only the window that gives it goes to both.
#pragma once

#include <span>

#include "solvers/core/window.h"

namespace geodesic::edge_based {

/// To which edges of a face the lines of a window lead; a line through the apex counts as both.
enum class Side : std::uint8_t { none, left, right, both };

/// The straight path to the apex that separates the windows of a list.
struct Separator {
  std::size_t window = SIZE_MAX;  ///< the one that gives it; SIZE_MAX when none sees the apex
  double distance = kInfinity;    ///< to the apex
  double crossing = 0;            ///< its position on the edge
  std::size_t rivals = 0;         ///< other windows of the list that see the apex
  bool any_left = false;          ///< some line of the list leads to the left edge
  bool any_right = false;
};

/// Length of the shortest path to the apex over one end of a window whose lines all pass on `side`.
double bent_distance(const Window& w, Side side, const FaceFrame& face);

/// Where the line from the window's source to the apex crosses the edge.
double crossing(const Window& w, const FaceFrame& face);

/// What remains of a window that is not the separator's own.
/// @param seen its `sides_seen`
/// @param best the separator's window
Side sides_kept(const Window& w, Side seen, const Separator& separator, const Window& best,
                const FaceFrame& face);

}  // namespace geodesic::edge_based
