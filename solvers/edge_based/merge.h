// Neighbouring windows of an edge joined: one shortened or dropped where it is nowhere shorter, two
// merged into one whose distances are nowhere too long and too short by no more than is allowed.
// That is what the thesis proposes as its next step (section 6.2.2), where Surazhsky, Surazhsky,
// Kirsanov, Gortler, Hoppe 2005 (section 4) merge pairs as they meet.
//
// Let F(t) be the least distance that the windows of a directed edge give to its point t, and G(p)
// the least of F(t) + |t p| over the edge, for the points p of the face that they enter. Exact
// propagation hands G on.
//
// Shortening. Along the edge, the difference of the distances that two windows a and b give has at
// most one extremum inside their overlap. Where a is the shorter one at its begin and b at its end,
// there is one crossing; two points that bracket it are found, a ends at the upper one and b begins
// at the lower one. Where one is nowhere shorter at both ends, and the source of the other lies to
// one side of all its lines there, so that the difference is monotonic, it keeps only what reaches
// beyond the overlap. F stays as it is, and so does G.
//
// Merging. Neighbours a and b that meet, or overlap by such a bracket, become one window m over
// both intervals when
//   1. m gives the begin of a the distance that a gives it, and the end of b that of b;
//   2. m is nowhere longer than a or b where these are;
//   3. every line of a and of b goes on, in the face, between the outermost lines of m;
//   4. its shortfall is at most `most` times its least distance. Up to a point of the bracket,
//   which
//      is called the tie, the truth is at most a + s(a), and beyond it at most b + s(b): s(m) is
//      the greater one of s(a) + the most by which m is shorter than a up to the tie, and s(b) +
//      the most by which it is shorter than b from there on.
// A window that a source sends has s = 0, and one that a vertex sends has that of the window that
// the vertex was reached by; what is unfolded or shortened keeps its own.
//
// Nothing is too long. By 1 and 2, m only lowers F and leaves no step in it; by 3, every p is
// reached in a straight line by m where it was by a or b, and no farther, since the straight line
// is the least of F(t) + |t p|: G is only lowered. So are, by induction over the faces that a
// shortest path crosses, the distances of its points: what is shortened or dropped in favour of
// another window, or of a path over a vertex, is so by comparing F and G themselves (by points of
// the edge and of the face beyond it, never by where unfolded sources lie, which says something
// about true paths only). A vertex that is reached has windows on both sides of it that give it its
// distance; on one of the sides the angle to any direction is at most pi, unless it is a saddle or
// a boundary vertex of more than pi, which sends windows everywhere. So what leads over a vertex is
// continued, too.
//
// A vertex P that sends a window p over the opposite edge sends only what others leave of it. Let a
// be the last window that came over the side of the face to the left of P. Where P lies to the
// right of all lines of a, p - a falls along the interval of a: where a is no longer than p at its
// end, it is so on all of it. Left of it, the first line of a meets the segment from P to the
// point: what the left side hands on there is no longer than p. So p begins where a ends; mirrored
// on the right.
//
// Nothing is shorter than the truth d by more than s. A distance that m gives to a point t of its
// interval is at least that of a or b, less the most in 4, and so at least d(t) - s(m) by
// induction. The distance of p is that of the point t of the interval in which m's line to p
// crosses the edge, and |t p|: at least d(t) - s(m) + |t p| >= d(p) - s(m). Along lines distances
// grow and s does not: with 4, s <= most * distance <= most * d everywhere.
//
// A vertex at the distance D with the shortfall s has D <= d <= D + s.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"
#include "solvers/edge_based/plain_lanes.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// A window, and how much shorter than the truth its distances may be.
struct MergedWindow {
  Window window;
  float shortfall;  ///< rounded up
};

/// What may be merged.
struct MergeRule {
  double most;   ///< the greatest shortfall, relative to distances
  double share;  ///< of what is left to that, the most that one merge adds: early wide merges would
                 ///< use it up, and leave more windows and larger errors
};

enum class Joined : std::uint8_t { neither, merged, first_gone, second_gone };

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

/// How far off a merged source may be, in distances: what is farther is a plane wave all but for
/// rounding.
inline constexpr double kFarthest = 16;

/// As a float that is no smaller.
inline float rounded_up(double shortfall) {
  constexpr float kUp = 1 + 2 * std::numeric_limits<float>::epsilon();
  return static_cast<float>(shortfall) * kUp;
}

/// A number of the first window and one of the second: what is asked of both is computed at once.
using plain::Double2;
using plain::Max;
using plain::Min;
using plain::Sqrt;

/// Two windows of an edge, as a pair of each of their numbers.
struct Neighbours {
  Double2 x, y, squared_y, sigma;

  Neighbours(const Window& a, const Window& b)
      : x{a.x, b.x}, y{a.y, b.y}, squared_y(y * y), sigma{a.sigma, b.sigma} {}

  /// The distances that they give: each one to a point of its own, or both to the same one.
  Double2 at(Double2 t) const {
    const Double2 along = t - x;
    return Sqrt(along * along + squared_y) + sigma;
  }
  Double2 at(double t) const { return at(Double2{t, t}); }

  /// The cosines to the edge of their lines through points of it.
  Double2 cosines(Double2 t, Double2 distances) const { return (t - x) / (distances - sigma); }
};

/// Where one window hands over to the next.
struct HandOver {
  Double2 from_here;     ///< the first one counts up to here, the second one from here on
  Double2 at_from_here;  ///< the distances that they give to these
  double tie;            ///< both count here, which lies between
  Double2 at_tie;
};

/// Brackets the one crossing of two windows that differ by `before` and `after` at `begin` and
/// `end` of their overlap.
inline HandOver crossing_of(const Neighbours& both, double begin, Double2 at_begin, double end,
                            Double2 at_end) {
  const double before = at_begin[0] - at_begin[1], after = at_end[0] - at_end[1];
  const double tie = begin + (end - begin) * (before / (before - after));
  const Double2 at_tie = both.at(tie);
  // On the other side of the crossing: twice the step of the secant, if that is enough.
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

/// How much shorter than two neighbours a window is where these count.
struct Lead {
  double least;  ///< negative where it is longer somewhere
  Double2 greatest;
};
/// @param outer where the first one begins and the second one ends
inline Lead lead_over(const Neighbours& both, const Window& m, Double2 outer, const HandOver& at) {
  const Neighbours merged(m, m);
  // The difference of two windows is greatest and least at ends, and where their lines coincide.
  const Double2 coincide = both.x - both.y * (merged.x - both.x) / (merged.y - both.y);
  const Double2 low{outer[0], at.from_here[1]}, high{at.from_here[0], outer[1]};
  const Double2 touch = Min(Max(coincide, low), high);
  const Double2 by_touch = both.at(touch) - merged.at(touch);
  const Double2 by_tie = at.at_tie - merged.at(at.tie);
  const Double2 by_end = at.at_from_here - merged.at(at.from_here);
  const Double2 least = Min(Min(by_touch, by_tie), by_end);
  return {std::min(least[0], least[1]), Max(Max(by_touch, by_tie), Double2{0, 0})};
}

}  // namespace internal

/// Shortens, drops or merges two neighbours of an edge as described above. When they are merged,
/// the first one becomes the merged one.
/// @param second the neighbour towards the head of the edge
/// @param length of the edge
/// @param rounding of coordinates (core/window_predicates.h)
inline Joined join(MergedWindow& first, MergedWindow& second, double length, double rounding,
                   const MergeRule& rule) {
  using internal::Double2;
  Window &a = first.window, &b = second.window;
  // Of a source on the edge all lines pass one point: they say nothing about an interval.
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
      if (b.begin < a.begin) {
        if (b.end > a.end) return Joined::neither;
        b.end = begin;
        return is_void(b, length) ? Joined::second_gone : Joined::neither;
      }
      b.begin = end;
      if (b.end <= a.end || is_void(b, length)) return Joined::second_gone;
      at = {Double2{end, end}, to, end, to};
    } else if (g_from >= -margin && g_to >= -margin && internal::is_to_one_side(b, a, begin, end)) {
      if (a.end > b.end) {
        if (a.begin < b.begin) return Joined::neither;
        a.begin = end;
        return is_void(a, length) ? Joined::first_gone : Joined::neither;
      }
      a.end = begin;
      if (a.begin >= b.begin || is_void(a, length)) return Joined::first_gone;
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
  // A merged window is convex: the chord is above it.
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
