// Strategy I: windows of one edge that cannot all be geodesic (thesis section 5.1.1).
//
// Two paths that meet at a point P cannot both be shortest beyond it. If the path of window W is
// shorter at P, every line of window V that crosses the segment from W's source to P is beaten
// there: the lines of V between the direction of P and the direction of W's source. Windows may
// still overlap afterwards; only lines that are certainly useless are removed.
#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/core/tolerance.h"
#include "solvers/core/window_predicates.h"

namespace geodesic::edge_based {

/// The edge that carries the windows, and the face below it through which they all came.
struct EdgeBelow {
  double length;            ///< of the edge
  double below_x, below_y;  ///< third vertex of the face below, below_y <= 0
  double rounding = 0;      ///< of coordinates (core/window_predicates.h)
};

/// @param h the half-edge that carries the windows; it must have a twin
/// @param rounding of coordinates
inline EdgeBelow edge_below(const Mesh& mesh, Index h, double rounding) {
  const HalfEdge& below = mesh.half_edge(mesh.twin(h));
  return {mesh.half_edge(h).length, below.length - below.apex_x, -below.apex_y, rounding};
}

// Everything here is inline, because it handles one window in five: out of line, a solve takes a
// tenth more instructions.

namespace internal {

inline double right_of_scale(const Window& w, double t, double px, double py) {
  return kOnLine * (std::abs(px - w.x) * -w.y + std::abs(t - w.x) * std::abs(py - w.y));
}

}  // namespace internal

/// True when the point (px, py) lies to the right of the window's line through t of the edge, or on
/// it within rounding.
inline bool is_right_of_line(const Window& w, double t, double px, double py) {
  return right_of(w, t, px, py) > -internal::right_of_scale(w, t, px, py);
}
/// True when the point lies to the left of that line, or on it within rounding.
inline bool is_left_of_line(const Window& w, double t, double px, double py) {
  return right_of(w, t, px, py) < internal::right_of_scale(w, t, px, py);
}

/// True when rounding alone may decide the side of that line: rounding of coordinates, or of
/// sources, accumulated over many faces. Two windows of one source, which came through different
/// strips, then have it in two places.
inline bool has_no_side(const Window& w, double t, double px, double py, double rounding) {
  const double lengths = std::abs(px - w.x) + std::abs(py - w.y) + std::abs(t - w.x) - w.y;
  return std::abs(right_of(w, t, px, py)) <= (rounding + kSourceRounding * lengths) * lengths;
}

/// Neighbours of which each protrudes beyond the other by less than this share of the narrower one
/// are not trimmed. All lines are real paths, so what is not cut changes no distance but for
/// rounding, only the time: with 0.25 in place of 0, less than half as many pairs are trimmed, and
/// windows rise by less than 1%. From 0.15 to 0.6 the times are alike.
inline constexpr double kLeastProtrusion = 0.25;

/// True when neighbours of a list are worth trimming: the second lies before the first, or the ends
/// of one are out of order by more than kLeastProtrusion.
inline bool out_of_order(const Window& first, const Window& second) {
  const double narrower = std::min(first.end - first.begin, second.end - second.begin);
  const double protrusion = std::max(first.begin - second.begin, first.end - second.end);
  return second.end <= first.begin || protrusion > kLeastProtrusion * narrower;
}

namespace internal {

/// Where the line from the source of w through (px, py) meets the edge; w.y < py.
inline double hit(const Window& w, double px, double py) {
  return w.x + (px - w.x) * (-w.y / (py - w.y));
}

/// Width that a window keeps beyond the position of its cut, because its last line and the first
/// line of the window beside it may diverge on the way.
inline double kept_beyond(const Window& loser, double p, double rounding) {
  return is_turned_by_rounding(loser, p, rounding) ? rounding : 0;
}

/// Trims the loser: `winner` is shorter at a point of the loser's line through position `p`.
/// Removes the lines of the loser between p and the direction of the winner's source. Removes
/// nothing when that source lies on the line itself and so has no side.
inline void cut(const Window& winner, Window& loser, double p, double rounding) {
  if (has_no_side(loser, p, winner.x, winner.y, rounding)) return;
  if (!is_left_of_line(loser, p, winner.x, winner.y)) {
    if (is_right_of_line(loser, loser.end, winner.x, winner.y)) {
      loser.end = std::clamp(p + kept_beyond(loser, p, rounding), loser.begin, loser.end);
    } else if (p <= loser.begin) {
      loser.begin = std::clamp(hit(loser, winner.x, winner.y), loser.begin, loser.end);
    }
  } else if (!is_right_of_line(loser, p, winner.x, winner.y)) {
    if (is_left_of_line(loser, loser.begin, winner.x, winner.y)) {
      loser.begin = std::clamp(p - kept_beyond(loser, p, rounding), loser.begin, loser.end);
    } else if (p >= loser.end) {
      loser.end = std::clamp(hit(loser, winner.x, winner.y), loser.begin, loser.end);
    }
  }
}

/// Decides which window is beaten at the point (px, py), on the line of `a` through `pa` and the
/// line of `b` through `pb`.
inline void decide(Window& a, double pa, Window& b, double pb, double px, double py,
                   double rounding) {
  const double da = distance_through(a, px, py);
  const double db = distance_through(b, px, py);
  if (is_shorter(da, db, rounding)) {
    cut(a, b, pb, rounding);
  } else if (is_shorter(db, da, rounding)) {
    cut(b, a, pa, rounding);
  }
}

/// `left` ends before `right` begins. Their facing boundary lines may cross below the edge.
inline void trim_apart(Window& left, Window& right, const EdgeBelow& edge) {
  const double depth_left = -left.y, depth_right = -right.y;
  // The lines drift by drift_left / depth_left per unit of depth.
  const double closing = (left.x - left.end) * depth_right - (right.x - right.begin) * depth_left;
  if (!(closing > 0)) return;
  const double depth = (right.begin - left.end) * depth_left * depth_right / closing;
  if (!(depth < depth_left) || !(depth < depth_right)) return;
  // Lines that meet in the third vertex of the face pass it on different sides: they come through
  // different strips, and neither crosses the other.
  if (!(depth < -edge.below_y * (1 - kNearVertex))) return;
  const double x = left.end + (left.x - left.end) * (depth / depth_left);
  // Inside the face below: between its two other edges at this depth.
  const double share = edge.below_y < 0 ? depth / -edge.below_y : 0;
  if (x < edge.below_x * share || x > edge.length + (edge.below_x - edge.length) * share) return;
  decide(left, left.end, right, right.begin, x, -depth, edge.rounding);
}

/// The distances of two windows at a point of the edge.
struct Pair {
  double t = 0, first = 0, second = 0;
};
inline Pair pair_at(const Window& first, const Window& second, double t) {
  return {t, distance_at(first, t), distance_at(second, t)};
}

/// As `decide`, for a point of the edge on both windows' lines.
inline void decide_at(const Pair& at, Window& first, Window& second, double rounding) {
  if (is_shorter(at.first, at.second, rounding)) {
    cut(first, second, at.t, rounding);
  } else if (is_shorter(at.second, at.first, rounding)) {
    cut(second, first, at.t, rounding);
  }
}

/// Whether the source of `of` lies on one side of all lines of `lines` through [begin, end].
inline bool is_to_one_side(const Window& lines, const Window& of, double begin, double end) {
  return (is_right_of_line(lines, begin, of.x, of.y) && is_right_of_line(lines, end, of.x, of.y)) ||
         (is_left_of_line(lines, begin, of.x, of.y) && is_left_of_line(lines, end, of.x, of.y));
}

/// Leaves of a window the part beyond its overlap [begin, end] with a shorter one. A window that
/// goes on at both ends of the overlap remains as it is.
inline void keep_beyond(Window& loser, double begin, double end, double rounding) {
  if (begin == loser.begin) {
    loser.begin = std::clamp(end - kept_beyond(loser, end, rounding), loser.begin, loser.end);
  } else if (end == loser.end) {
    loser.end = std::clamp(begin + kept_beyond(loser, begin, rounding), loser.begin, loser.end);
  }
}

/// Trims the windows on their overlap if neither of its ends was decided. If the winner is nowhere
/// longer on it, the loser keeps only the part beyond it. A tie at one end is the usual case: the
/// loser's source is a vertex on the line that bounds the winner's pencil, and the winner's shadow
/// begins there.
///
/// Along the edge, the difference of the distances changes by the difference of the cosines of the
/// lines' angles. It keeps its sign while the loser's source stays on one side of the winner's
/// lines: the two ends then decide for the whole overlap.
inline void settle_overlap(Window& first, Window& second, const Pair& begin, const Pair& end,
                           double rounding) {
  bool first_wins = !is_shorter(begin.second, begin.first, rounding) &&
                    !is_shorter(end.second, end.first, rounding);
  bool second_wins = !is_shorter(begin.first, begin.second, rounding) &&
                     !is_shorter(end.first, end.second, rounding);
  // If both ends tie, the window of smaller sum wins: beside a source next to a vertex, the path
  // round that vertex may be longer by less than the rounding of long edges.
  if (first_wins && second_wins) {
    first_wins = begin.first + end.first <= begin.second + end.second;
    second_wins = !first_wins;
  }
  if (first_wins && is_to_one_side(first, second, begin.t, end.t)) {
    keep_beyond(second, begin.t, end.t, rounding);
  } else if (second_wins && is_to_one_side(second, first, begin.t, end.t)) {
    keep_beyond(first, begin.t, end.t, rounding);
  }
}

}  // namespace internal

/// Compares two windows of one edge and trims from each the lines that the other beats. A window
/// that is beaten wholly becomes void. Compares them on their overlap on the edge, or, if they are
/// apart, where their boundary lines cross inside the face below. If the source of one touches the
/// edge, both remain unchanged.
inline void trim_pair(Window& first, Window& second, const EdgeBelow& edge) {
  if (source_on_edge(first, edge.length) || source_on_edge(second, edge.length)) return;
  if (first.end <= second.begin) return internal::trim_apart(first, second, edge);
  if (second.end <= first.begin) return internal::trim_apart(second, first, edge);
  // Windows that a vertex has cut apart may overlap by rounding.
  if (first.end - second.begin <= edge.rounding || second.end - first.begin <= edge.rounding) {
    return;
  }
  const double begin = std::max(first.begin, second.begin);
  internal::Pair at_begin = internal::pair_at(first, second, begin);
  internal::decide_at(at_begin, first, second, edge.rounding);
  const double end = std::min(first.end, second.end);
  const double still = std::max(first.begin, second.begin);
  if (end <= still) return;
  internal::Pair at_end = internal::pair_at(first, second, end);
  internal::decide_at(at_end, first, second, edge.rounding);
  const double left_begin = std::max(first.begin, second.begin);
  const double left_end = std::min(first.end, second.end);
  if (!(left_begin < left_end)) return;
  if (left_begin != begin) at_begin = internal::pair_at(first, second, left_begin);
  if (left_end != end) at_end = internal::pair_at(first, second, left_end);
  internal::settle_overlap(first, second, at_begin, at_end, edge.rounding);
}

/// The part of `trim_pair` that does not depend on the faces through which the windows came: if one
/// is nowhere longer on their overlap, the other keeps only the part beyond it.
inline void trim_overlap(Window& first, Window& second, const EdgeBelow& edge) {
  if (source_on_edge(first, edge.length) || source_on_edge(second, edge.length)) return;
  const double begin = std::max(first.begin, second.begin), end = std::min(first.end, second.end);
  if (end - begin <= edge.rounding) return;
  internal::settle_overlap(first, second, internal::pair_at(first, second, begin),
                           internal::pair_at(first, second, end), edge.rounding);
}

}  // namespace geodesic::edge_based
