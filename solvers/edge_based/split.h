// Strategy II: one angle, two sides (thesis section 5.1.2).
//
// The shortest path from the windows of an edge to the opposite vertex, the apex, separates them: a
// line that crosses this path inside the face is no geodesic. Windows left of it go to the left
// edge, windows right of it to the right edge. Only the window of the path itself goes to both.
#pragma once

#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// The edges of a face to which the lines of a window lead; a line through the apex counts as both.
enum class Side : std::uint8_t { none, left, right, both };

/// The straight path to the apex that separates the windows of a list.
struct ApexWinner {
  std::size_t window = SIZE_MAX;  ///< the window of the path; SIZE_MAX when none sees the apex
  double distance = kInfinity;    ///< to the apex
  double position = 0;            ///< its position on the edge
  bool is_contested = false;      ///< some other window needs `sides_kept`
};

/// Length of the shortest path to the apex over one end of a window whose lines all pass on `side`.
inline double bent_distance(const Window& w, Side side, const FaceFrame& face) {
  const double bend = side == Side::left ? w.end : w.begin;
  const double dx = face.apex_x - bend;
  return distance_at(w, bend) + std::sqrt(dx * dx + face.apex_y * face.apex_y);
}

/// The position in the window's interval that is nearest to apex_line_position.
inline double apex_line_in(const Window& w, const FaceFrame& face) {
  return std::clamp(apex_line_position(w, face), w.begin, w.end);
}

/// Returns the sides that remain of a window other than the winner's.
/// @param seen the sides that its lines pass
/// @param best the winner's window
/// @param rounding of coordinates (core/window_predicates.h)
inline Side sides_kept(const Window& w, Side seen, const ApexWinner& winner, const Window& best,
                       const FaceFrame& face, double rounding) {
  if (seen == Side::both) {
    // Windows that meet in the line to the apex both see it: in a tie both keep all lines.
    const double distance = distance_through(w, face.apex_x, face.apex_y);
    if (!is_shorter(winner.distance, distance, rounding)) return seen;
    // Its line to the apex is longer. The lines between that line and the winner's source are
    // beaten: one whole side, unless the source lies inside the pencil. This requires that the
    // winner's path crosses the edge on the side of its source. Round the end of its own window, at
    // a saddle vertex, it may cross on the other side: it then crosses no line.
    const double t = apex_line_in(w, face);
    if (source_on_edge(w, face.length) || has_no_side(w, t, best.x, best.y, rounding)) return seen;
    if (!is_left_of_line(w, t, best.x, best.y) && winner.position >= t) {
      return is_right_of_line(w, w.end, best.x, best.y) ? Side::left : Side::both;
    }
    if (!is_right_of_line(w, t, best.x, best.y) && winner.position <= t) {
      return is_left_of_line(w, w.begin, best.x, best.y) ? Side::right : Side::both;
    }
    return Side::both;
  }
  const bool crosses = seen == Side::left ? w.begin >= winner.position : w.end <= winner.position;
  if (crosses && is_shorter(winner.distance, bent_distance(w, seen, face), rounding)) {
    return Side::none;
  }
  return seen;
}

}  // namespace geodesic::edge_based
