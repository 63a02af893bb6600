// Joins neighbouring windows of an edge: shortens or drops a window that is nowhere shorter, or
// merges two into one whose distances are nowhere too long, and too short by a bounded amount only.
// The thesis proposes this as its next step (section 6.2.2); Surazhsky, Surazhsky, Kirsanov,
// Gortler, Hoppe 2005 (section 4) merge pairs as they meet.
//
// Let F(t) be the least distance that the windows of a directed edge give to its point t, and G(p)
// the least of F(t) + |t p| over the edge, for points p of the face that they enter. Exact
// propagation passes G on.
//
// Shortening. Along the edge, the difference of the distances of two windows a and b has at most
// one extremum inside their overlap. If a is shorter at the overlap's begin and b at its end, there
// is one intersection. Two points that bracket it are computed; a ends at the upper one and b
// begins at the lower one. If one window is shorter at neither end, and the source of the other
// lies to one side of all its lines there, so that the difference is monotonic, it keeps only the
// part beyond the overlap. F does not change, and so neither does G.
//
// Merging. Neighbours a and b that meet, or overlap by such a bracket, become one window m over
// both intervals when
//   1. at the begin of a, m gives the same distance as a, and at the end of b the same as b;
//   2. m is nowhere longer than a or b where these are;
//   3. every line of a and of b goes on, in the face, between the outermost lines of m;
//   4. the shortfall of m is at most `most` times its least distance. Up to a point of the bracket,
//      the tie, the truth is at most a + s(a), and beyond it at most b + s(b). s(m) is the greater
//      of two sums: s(a) plus the most by which m is shorter than a up to the tie, and s(b) plus
//      the most by which m is shorter than b from the tie on.
// A window from a source has s = 0. A window from a vertex has the s of the window that reached the
// vertex. Unfolding and shortening keep s.
//
// No distance is too long. By 1 and 2, m only lowers F and leaves no step in it. By 3, m reaches in
// a straight line every p that a or b reached so, at no greater distance, since the straight line
// is the least of F(t) + |t p|: G is only lowered. By induction over the faces that a shortest path
// crosses, so are the distances of its points: a window is shortened or dropped in favour of
// another window, or of a path over a vertex, by comparing F and G themselves (at points of the
// edge and of the face beyond it, never by the positions of unfolded sources, which describe true
// paths only). A reached vertex has windows on both sides that give it its distance; on one side
// the angle to any direction is at most pi, unless the vertex is a saddle or a boundary vertex of
// more than pi, which sends windows everywhere. So paths over a vertex are continued, too.
//
// A vertex P that sends a window p over the opposite edge sends only the part that others leave.
// Let a be the last window that came over the side of the face to the left of P. If P lies to the
// right of all lines of a, p - a falls along the interval of a: if a is no longer than p at its
// end, it is so on all of the interval. Left of it, the first line of a meets the segment from P to
// the point: the distance from the left side is no longer than p there. So p begins where a ends;
// mirrored on the right.
//
// No distance is shorter than the truth d by more than s. The distance from m at a point t of its
// interval is at least that of a or b, less the most in 4: at least d(t) - s(m) by induction. If
// m's line to p crosses the edge at t, the distance of p is that of t plus |t p|, which is at least
// d(t) - s(m) + |t p| >= d(p) - s(m). Along lines distances grow and s does not: with 4,
// s <= most * distance <= most * d everywhere.
//
// A vertex at distance D with shortfall s has D <= d <= D + s.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// A window, and the largest error by which its distances may be too short.
struct MergedWindow {
  Window window;
  float shortfall;  ///< rounded up
};

/// Limits of merging.
struct MergeRule {
  double most;   ///< the greatest shortfall, relative to distances
  double share;  ///< largest share of the remaining shortfall that one merge may add: early wide
                 ///< merges would use it up, and leave more windows and larger errors
};

enum class Joined : std::uint8_t { neither, merged, first_gone, second_gone };

namespace internal {

/// Finds the source of a merged window from the distances at both ends of the interval. The unknown
/// is its distance from the begin. The farther the source is, the straighter is the wave, the
/// longer are the distances inside the interval, and the narrower is the pencil of lines.
struct MergedSource {
  double begin, end;
  double at_begin, at_end;  ///< distances
  double away;  ///< distance from the begin: the largest that all conditions so far allow

  double width() const { return end - begin; }
  double rise() const { return at_end - at_begin; }
  double squares() const { return width() * width() - rise() * rise(); }

  /// Requires that the window's first and last lines are not inside those with these cosines.
  void take_in(double first, double last) {
    const double left = rise() - first * width(), right = last * width() - rise();
    if (left > 0) away = std::min(away, squares() / (2 * left));
    if (right > 0) away = std::min(away, squares() / (2 * right) - rise());
  }

  /// Requires that the window is not longer than `distance` at t.
  void stay_below(double t, double distance) {
    const double along = t - begin, up = distance - at_begin;
    const double below_chord = rise() * along / width() - up;
    if (!(below_chord > 0)) return;
    const double least = up * up - along * along + along * squares() / width();
    away = std::min(away, least / (2 * below_chord));
  }

  /// Computes the window. @return false when no such source exists
  bool make(Window& w) const {
    if (!(away > 0 && away + rise() > 0)) return false;
    const double behind = (2 * away * rise() - squares()) / (2 * width());
    const double square = away * away - behind * behind;
    if (!(square > 0)) return false;
    w = {begin, end, begin - behind, -std::sqrt(square), at_begin - away};
    return true;
  }
};

/// Largest distance of a merged source, in multiples of the distances: a farther source is a plane
/// wave up to rounding.
inline constexpr double kFarthest = 16;

/// Converts to a float that is not smaller.
inline float rounded_up(double shortfall) {
  constexpr float kUp = 1 + 2 * std::numeric_limits<float>::epsilon();
  return static_cast<float>(shortfall) * kUp;
}

/// One number of each of two windows, in one vector: both are computed at once.
using Double2 = double __attribute__((vector_size(16)));
inline Double2 sqrt_of(Double2 a) { return Double2{std::sqrt(a[0]), std::sqrt(a[1])}; }
inline Double2 min_of(Double2 a, Double2 b) { return a < b ? a : b; }
inline Double2 max_of(Double2 a, Double2 b) { return a > b ? a : b; }

/// Two windows of an edge, with each field as a pair.
struct Neighbours {
  Double2 x, y, squared_y, sigma;

  Neighbours(const Window& a, const Window& b)
      : x{a.x, b.x}, y{a.y, b.y}, squared_y(y * y), sigma{a.sigma, b.sigma} {}

  /// The distances of both windows: each at a point of its own, or both at the same point.
  Double2 at(Double2 t) const {
    const Double2 along = t - x;
    return sqrt_of(along * along + squared_y) + sigma;
  }
  Double2 at(double t) const { return at(Double2{t, t}); }

  /// The cosines to the edge of both windows' lines through points of it.
  Double2 cosines(Double2 t, Double2 distances) const { return (t - x) / (distances - sigma); }
};

/// The place where one window ends and the next one begins.
struct HandOver {
  Double2 from_here;     ///< end of the first window and begin of the second one
  Double2 at_from_here;  ///< the windows' distances at these points
  double tie;            ///< a point between, where both count
  Double2 at_tie;
};

/// Brackets the only intersection of two windows whose difference is `before` at `begin` and
/// `after` at `end` of their overlap.
inline HandOver crossing_of(const Neighbours& both, double begin, Double2 at_begin, double end,
                            Double2 at_end) {
  const double before = at_begin[0] - at_begin[1], after = at_end[0] - at_end[1];
  const double tie = begin + (end - begin) * (before / (before - after));
  const Double2 at_tie = both.at(tie);
  // A point on the other side of the intersection: twice the secant step, if that is enough.
  const double g = at_tie[0] - at_tie[1];
  const bool above = g > 0;
  const double far = above ? begin : end;
  double other = tie - 2 * g * (tie - far) / (g - (above ? before : after));
  other = above ? std::max(begin, other) : std::min(end, other);
  Double2 at_other = both.at(other);
  const double g_other = at_other[0] - at_other[1];
  if (above ? !(g_other <= 0) : !(g_other >= 0)) {
    other = far;
    at_other = above ? at_begin : at_end;
  }
  if (above) return {Double2{tie, other}, Double2{at_tie[0], at_other[1]}, tie, at_tie};
  return {Double2{other, tie}, Double2{at_other[0], at_tie[1]}, tie, at_tie};
}

/// How much shorter a window is than two neighbours, each where it counts.
struct Lead {
  double least;  ///< negative when the window is longer somewhere
  Double2 greatest;
};
/// @param outer begin of the first neighbour and end of the second one
inline Lead lead_over(const Neighbours& both, const Window& m, Double2 outer, const HandOver& at) {
  const Neighbours merged(m, m);
  // The difference of two windows is extremal at ends, and where their lines coincide.
  const Double2 coincide = both.x - both.y * (merged.x - both.x) / (merged.y - both.y);
  const Double2 low{outer[0], at.from_here[1]}, high{at.from_here[0], outer[1]};
  const Double2 touch = min_of(max_of(coincide, low), high);
  const Double2 by_touch = both.at(touch) - merged.at(touch);
  const Double2 by_tie = at.at_tie - merged.at(at.tie);
  const Double2 by_end = at.at_from_here - merged.at(at.from_here);
  const Double2 least = min_of(min_of(by_touch, by_tie), by_end);
  return {std::min(least[0], least[1]), max_of(max_of(by_touch, by_tie), Double2{0, 0})};
}

}  // namespace internal

/// Shortens, drops or merges two neighbours of an edge as described above. After a merge the first
/// one is the merged window.
/// @param second the neighbour towards the head of the edge
/// @param length of the edge
/// @param rounding of coordinates (core/window_predicates.h)
inline Joined join(MergedWindow& first, MergedWindow& second, double length, double rounding,
                   const MergeRule& rule) {
  using internal::Double2;
  Window &a = first.window, &b = second.window;
  // If a source lies on the edge, all its lines pass one point: they say nothing about an interval.
  if (std::max(a.y, b.y) > -kFlatFace * length) return Joined::neither;
  const internal::Neighbours both(a, b);
  const Double2 outer{a.begin, b.end}, at_outer = both.at(outer);
  const double at_begin = at_outer[0], at_end = at_outer[1];

  internal::HandOver at;
  const double begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
  if (end - begin > rounding) {
    const Double2 from = both.at(begin), to = both.at(end);
    const double margin = kPathMargin * from[0] + rounding;
    const double g_from = from[0] - from[1], g_to = to[0] - to[1];
    if (g_from < -margin && g_to > margin) {
      if (b.begin < a.begin || b.end < a.end) return Joined::neither;
      at = internal::crossing_of(both, begin, from, end, to);
      a.end = at.from_here[0];
      b.begin = at.from_here[1];
    } else if (g_from <= margin && g_to <= margin && internal::is_to_one_side(a, b, begin, end)) {
      internal::keep_beyond(b, begin, end, 0);
      if (is_void(b, length)) return Joined::second_gone;
      if (b.begin != end) return Joined::neither;
      at = {Double2{end, end}, to, end, to};
    } else if (g_from >= -margin && g_to >= -margin && internal::is_to_one_side(b, a, begin, end)) {
      internal::keep_beyond(a, begin, end, 0);
      if (is_void(a, length)) return Joined::first_gone;
      if (a.end != begin) return Joined::neither;
      at = {Double2{begin, begin}, from, begin, from};
    } else {
      return Joined::neither;
    }
  } else {
    const bool meet =
        b.begin > a.begin && b.end > a.end && begin <= end + 4 * kWindowWidth * length;
    if (!meet) return Joined::neither;
    const Double2 ends{a.end, b.begin};
    at = {ends, both.at(ends), a.end, both.at(a.end)};
  }

  const double before = double{std::max(first.shortfall, second.shortfall)};
  const double most_added = rule.share * (rule.most * std::min(at_begin, at_end) - before);
  internal::MergedSource source{a.begin, b.end, at_begin, at_end, 0};
  // A merged window's distances are convex: the chord lies above them.
  const double at_tie = std::min(at.at_tie[0], at.at_tie[1]);
  const double chord = at_begin + source.rise() * (at.tie - a.begin) / source.width();
  if (at_tie - chord > most_added || !(source.squares() > 0)) return Joined::neither;
  source.away = internal::kFarthest * std::max(at_begin, at_end);
  const Double2 firsts =
      both.cosines(Double2{a.begin, at.from_here[1]}, Double2{at_begin, at.at_from_here[1]});
  const Double2 lasts =
      both.cosines(Double2{at.from_here[0], b.end}, Double2{at.at_from_here[0], at_end});
  source.take_in(std::min(firsts[0], firsts[1]), std::max(lasts[0], lasts[1]));
  source.stay_below(at.tie, at_tie);
  Window m{};
  if (!source.make(m) || m.y > -kLeastAway * length) return Joined::neither;
  const internal::Lead lead = internal::lead_over(both, m, outer, at);
  if (-lead.least > kPathMargin * std::max(at_begin, at_end)) return Joined::neither;
  const float shortfall = internal::rounded_up(
      std::max(first.shortfall + lead.greatest[0], second.shortfall + lead.greatest[1]));
  const double allowed = rule.most * least_distance(m);
  if (!(shortfall <= allowed && shortfall - before <= rule.share * (allowed - before))) {
    return Joined::neither;
  }
  first = {m, shortfall};
  return Joined::merged;
}

}  // namespace geodesic::edge_based
