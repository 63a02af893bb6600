// Strategy II: one angle, two sides (thesis section 5.1.2).
//
// The shortest path from the windows of an edge to the opposite vertex, the apex, separates them: a
// line that crosses this path inside the face is no geodesic. Windows left of it go to the left
// edge, windows right of it to the right edge. Only the window of the path itself goes to both.
#pragma once

#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// The shortest path through a window of a list to the apex. It separates the windows of the list.
struct ApexWinner {
  std::size_t window = SIZE_MAX;  ///< the window of the path; SIZE_MAX when none reaches the apex
  double distance = kInfinity;    ///< to the apex
  double position = 0;            ///< of the path on the edge
  bool is_contested = false;      ///< some other window needs `sides_kept`
};

/// The position in the window's interval that is nearest to apex_line_position.
inline double apex_line_in(const Window& w, const FaceFrame& face) {
  return std::clamp(apex_line_position(w, face), w.begin, w.end);
}

/// Returns the sides that remain of a window other than the winner's.
/// @param seen the sides on which its lines pass the apex; it is contested
/// @param best the winner's window
/// @param rounding of coordinates (core/window_predicates.h)
inline Sides sides_kept(const Window& w, Sides seen, const ApexWinner& winner, const Window& best,
                        const FaceFrame& face, double rounding) {
  // Windows that meet in the line to the apex both reach it: in a tie both keep all lines.
  if (!is_shorter(winner.distance, distance_to_apex(w, seen, face), rounding)) return seen;
  if (!seen.left || !seen.right) return sides_not_crossing(seen, w.begin, w.end, winner.position);
  // The sources decide even if the winner's path crosses the interval: all lines between the
  // window's line to the apex and the direction of the winner's source are beaten. That is one
  // whole side, unless the source lies inside the pencil. The winner's path must cross the edge on
  // the side of its source: round the end of its own window, at a saddle vertex, it may not, and
  // crosses no line then.
  const double t = apex_line_in(w, face);
  if (source_on_edge(w, face.length) || has_no_side(w, t, best.x, best.y, rounding)) return seen;
  if (!is_left_of_line(w, t, best.x, best.y) && winner.position >= t) {
    return {true, !is_right_of_line(w, w.end, best.x, best.y)};
  }
  if (!is_right_of_line(w, t, best.x, best.y) && winner.position <= t) {
    return {!is_left_of_line(w, w.begin, best.x, best.y), true};
  }
  return seen;
}

}  // namespace geodesic::edge_based
