// Windows of an edge merged into one, whose distances are nowhere too long and too short by no more
// than is allowed: what the thesis proposes as its next step (section 6.2.2), where Surazhsky,
// Surazhsky, Kirsanov, Gortler, Hoppe 2005 (section 4) merge pairs as they meet.
//
// Let F(t) be the least distance that the windows of a directed edge give to its point t, and G(p)
// the least of F(t) + |t p| over the edge, for the points p of the face that they enter. Exact
// propagation hands G on. Two neighbours a and b of the list, with intervals that meet or overlap,
// become one window m over both intervals when
//   1. m gives the begin of a the distance that a gives it, and the end of b that of b;
//   2. m is nowhere longer than a or b where these are;
//   3. every line of a and of b goes on, in the face, between the outermost lines of m;
//   4. the shortfall of m, s(m) = max(s(a), s(b)) + the most by which m is shorter than the shorter
//      one of a and b, is at most the tolerance times the least distance of m.
// A window that a source sends has s = 0, and one that a vertex sends has that of the window that
// the vertex was reached by; what is unfolded or trimmed keeps its own.
//
// Nothing is too long. By 1 and 2, m only lowers F and leaves no step in it; by 3, every p is
// reached in a straight line by m where it was by a or b, and no farther, since the straight line
// is the least of F(t) + |t p|: G is only lowered. So are, by induction over the faces that a
// shortest path crosses, the distances of its points: what is trimmed or dropped in favour of
// another window, or of a path over a vertex, is so by comparing F and G themselves (by points of
// the edge and of the face beyond it, never by where unfolded sources lie, which says something
// about true paths only). A vertex that is reached has windows on both sides of it that give it its
// distance; on one of the sides the angle to any direction is below pi, unless it is a saddle or
// boundary vertex, which sends windows everywhere. So what leads over a vertex is continued, too.
//
// Nothing is shorter than the truth d by more than s. A distance that m gives to a point t of its
// interval is at least that of a or b, less the most in 4, and so at least d(t) - s(m) by
// induction. The distance of p is that of the point t of the interval in which m's line to p
// crosses the edge, and |t p|: at least d(t) - s(m) + |t p| >= d(p) - s(m). Along lines distances
// grow and s does not: with 4, s <= tolerance * distance <= tolerance * d everywhere.
//
// A vertex at the distance D with the shortfall s has D <= d <= D + s.
#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"

namespace geodesic::edge_based {

/// A window and what is known of its distances.
struct MergedWindow {
  Window window;
  double shortfall;  ///< how much shorter than the truth they may be
  double depth;      ///< of its strip, in faces: a whole number
};

namespace internal {

/// Of a merged window's source, with the distances at both ends of the interval given: how far it
/// is from the begin. The farther it is, the straighter is the wave, the longer are the distances
/// inside the interval, and the narrower is the pencil of lines.
struct MergedSource {
  double begin, end;
  double at_begin, at_end;  ///< distances
  double away;              ///< from the begin, the most that all conditions so far allow

  double width() const { return end - begin; }
  double rise() const { return at_end - at_begin; }
  double squares() const { return width() * width() - rise() * rise(); }

  /// The window's first and last lines must not be inside those with these cosines to the edge.
  void take_in(double first, double last) {
    const double left = rise() - first * width(), right = last * width() - rise();
    if (left > 0) away = std::min(away, squares() / (2 * left));
    if (right > 0) away = std::min(away, squares() / (2 * right) - rise());
  }

  /// The window must not be longer at t.
  void stay_below(double t, double distance) {
    const double along = t - begin, up = distance - at_begin;
    const double below_chord = rise() * along / width() - up;
    if (!(below_chord > 0)) return;
    const double least = up * up - along * along + along * squares() / width();
    away = std::min(away, least / (2 * below_chord));
  }

  /// @return false when no such source exists
  bool make(Window& w) const {
    if (!(away > 0 && away + rise() > 0)) return false;
    const double behind = (2 * away * rise() - squares()) / (2 * width());
    const double square = away * away - behind * behind;
    if (!(square > 0)) return false;
    w = {begin, end, begin - behind, -std::sqrt(square), at_begin - away};
    return true;
  }
};

/// Of the line from a window's source through position t, to the edge.
inline double cosine(const Window& w, double t) {
  const double dx = t - w.x;
  return dx / std::sqrt(dx * dx + w.y * w.y);
}

/// Where the windows a and b, of which b begins and ends later, are equally long on their overlap,
/// nearly; where b takes over from a if they are nowhere so.
inline double tie_of(const Window& a, const Window& b) {
  if (b.begin >= a.end) return a.end;
  const double before = distance_at(a, b.begin) - distance_at(b, b.begin);
  if (before >= 0) return b.begin;
  const double after = distance_at(a, a.end) - distance_at(b, a.end);
  if (after <= 0) return a.end;
  return b.begin + (a.end - b.begin) * (before / (before - after));
}

/// How far off a merged source may be, in distances: what is farther is a plane wave all but for
/// rounding.
inline constexpr double kFarthest = 16;

/// How often a merged source that is too far is taken back to where the window touches, and by how
/// much more, so that it ends below.
inline constexpr int kTurns = 4;
inline constexpr double kTakeBack = 0.98;

}  // namespace internal

/// Merges `next` into `pencil`, its neighbour towards the origin of the edge, where the conditions
/// above allow it.
/// @param length of the edge
/// @param tolerance the greatest shortfall, relative to distances
/// @return false when they do not; nothing has changed then
inline bool merge(MergedWindow& pencil, const MergedWindow& next, double length, double tolerance) {
  const Window &a = pencil.window, &b = next.window;
  const double most = tolerance * least_distance(a);
  const double before = std::max(pencil.shortfall, next.shortfall);
  if (before > most && before > tolerance * least_distance(b)) return false;
  if (!(b.begin > a.begin && b.end > a.end) || b.begin > a.end + 4 * kWindowWidth * length) {
    return false;
  }
  // Of a source on the edge all lines pass one point: they say nothing about an interval.
  if (a.y > -kFlatFace * length || b.y > -kFlatFace * length) return false;

  internal::MergedSource source{a.begin, b.end, distance_at(a, a.begin), distance_at(b, b.end), 0};
  if (!(source.squares() > 0)) return false;
  source.away = internal::kFarthest * std::max(source.at_begin, source.at_end);
  source.take_in(std::min(internal::cosine(a, a.begin), internal::cosine(b, b.begin)),
                 std::max(internal::cosine(a, a.end), internal::cosine(b, b.end)));
  const double tie = internal::tie_of(a, b);
  const double a_at_tie = distance_at(a, tie), b_at_tie = distance_at(b, tie);
  source.stay_below(tie, std::min(a_at_tie, b_at_tie));

  const double rounding = kPathMargin * std::max(source.at_begin, source.at_end);
  Window m{};
  double shorter = 0;  // than the two, at most
  for (int turn = 0;; ++turn) {
    if (turn == internal::kTurns || !source.make(m)) return false;
    bool longer = false;
    shorter = std::max(a_at_tie, b_at_tie) - distance_at(m, tie);
    // By how much the merged window is shorter; where it is longer, its source comes nearer.
    const auto lead = [&](const Window& w, double t) {
      const double distance = distance_at(w, t), by = distance - distance_at(m, t);
      if (by < -rounding) {
        longer = true;
        source.stay_below(t, distance);
        source.away *= internal::kTakeBack;
      }
      return by;
    };
    // The difference of two windows is greatest and least at ends, and where their lines coincide.
    for (const Window* w : {&a, &b}) {
      const double t = w->x - w->y * (m.x - w->x) / (m.y - w->y);
      if (t > w->begin && t < w->end) shorter = std::max(shorter, lead(*w, t));
    }
    if (b.begin < a.end) {
      lead(a, a.end);
      lead(b, b.begin);
    }
    if (!longer) break;
  }
  const double shortfall = before + std::max(shorter, 0.0);
  if (!(shortfall <= tolerance * least_distance(m))) return false;
  pencil = {m, shortfall, std::max(pencil.depth, next.depth)};
  return true;
}

}  // namespace geodesic::edge_based
