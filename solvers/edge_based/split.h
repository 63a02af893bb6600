// Strategy II: one angle, two sides (thesis section 5.1.2).
//
// The shortest path from the windows of an edge to the opposite vertex, the apex, separates them:
// what crosses that path inside the face is no geodesic. Windows left of it go to the left edge,
// right of it to the right edge, and only the window that gives it goes to both.
#pragma once

#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// To which edges of a face the lines of a window lead; a line through the apex counts as both.
enum class Side : std::uint8_t { none, left, right, both };

/// The straight path to the apex that separates the windows of a list.
struct ApexWinner {
  std::size_t window = SIZE_MAX;  ///< the one that gives it; SIZE_MAX when none sees the apex
  double distance = kInfinity;    ///< to the apex
  double crossing = 0;            ///< its position on the edge
  bool is_contested = false;      ///< by another window: `sides_kept` decides on that
  bool any_left = false;          ///< some line of the list leads to the left edge
  bool any_right = false;
};

/// Length of the shortest path to the apex over one end of a window whose lines all pass on `side`.
inline double bent_distance(const Window& w, Side side, const FaceFrame& face) {
  const double bend = side == Side::left ? w.end : w.begin;
  const double dx = face.apex_x - bend;
  return distance_at(w, bend) + std::sqrt(dx * dx + face.apex_y * face.apex_y);
}

/// The position of the window's interval that is nearest to it.
inline double crossing(const Window& w, const FaceFrame& face) {
  return std::clamp(line_crossing(w, face), w.begin, w.end);
}

/// What remains of a window that is not the winner's own.
/// @param seen the sides that its lines pass
/// @param best the winner's window
/// @param rounding of coordinates (core/window_predicates.h)
inline Side sides_kept(const Window& w, Side seen, const ApexWinner& winner, const Window& best,
                       const FaceFrame& face, double rounding) {
  if (seen == Side::both) {
    // Windows that meet in the line to the apex both see it: a tie leaves both whole.
    const double distance = distance_through(w, face.apex_x, face.apex_y);
    if (!is_shorter(winner.distance, distance, rounding)) return seen;
    // Its line to the apex is the longer one: lines between that and the winner's source are
    // beaten, which is one whole side unless the source lies inside the pencil.
    // The winner's path must come over the edge on the side of its source. Round the end of its own
    // window, which a saddle vertex bounds, it may come on the other one: it crosses no line then.
    const double t = crossing(w, face);
    if (source_on_edge(w, face.length) || has_no_side(w, t, best.x, best.y, rounding)) return seen;
    if (!is_left_of_line(w, t, best.x, best.y) && winner.crossing >= t) {
      return is_right_of_line(w, w.end, best.x, best.y) ? Side::left : Side::both;
    }
    if (!is_right_of_line(w, t, best.x, best.y) && winner.crossing <= t) {
      return is_left_of_line(w, w.begin, best.x, best.y) ? Side::right : Side::both;
    }
    return Side::both;
  }
  const bool crosses = seen == Side::left ? w.begin >= winner.crossing : w.end <= winner.crossing;
  if (crosses && is_shorter(winner.distance, bent_distance(w, seen, face), rounding)) {
    return Side::none;
  }
  return seen;
}

}  // namespace geodesic::edge_based
