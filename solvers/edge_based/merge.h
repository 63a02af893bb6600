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
// distance; on one of the sides the angle to any direction is below pi, unless it is a saddle or
// boundary vertex, which sends windows everywhere. So what leads over a vertex is continued, too.
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

inline float rounded_up(double shortfall) {
  const auto near = static_cast<float>(shortfall);
  return near < shortfall ? std::nextafter(near, std::numeric_limits<float>::max()) : near;
}

/// Where one window hands over to the next. Up to `last` the first one counts, from `next` on the
/// second one; both do at the tie, which lies between.
struct HandOver {
  double last, next, tie;
  double first_at_last, second_at_next;  ///< distances
  double first_at_tie, second_at_tie;
};

/// Brackets the one crossing of two windows that are a and b at `begin` and `end` of their overlap.
inline HandOver crossing_of(const Window& a, const Window& b, const Pair& begin, const Pair& end) {
  const double before = begin.first - begin.second, after = end.first - end.second;
  const Pair tie = pair_at(a, b, begin.t + (end.t - begin.t) * (before / (before - after)));
  // On the other side of the crossing: twice the step of the secant, if that is enough.
  const double g = tie.first - tie.second;
  const bool above = g > 0;
  const Pair& far = above ? begin : end;
  double t = tie.t - 2 * g * (tie.t - far.t) / (g - (far.first - far.second));
  t = above ? std::max(begin.t, t) : std::min(end.t, t);
  Pair other = pair_at(a, b, t);
  const double g_other = other.first - other.second;
  if (above ? !(g_other <= 0) : !(g_other >= 0)) other = far;
  const Pair &low = above ? other : tie, &high = above ? tie : other;
  return {high.t, low.t, tie.t, high.first, low.second, tie.first, tie.second};
}

/// How much shorter than `w` the window m is, from `begin` to `end`.
struct Lead {
  double least, greatest;  ///< the least is negative where m is longer somewhere
};
/// @param at_tie, at_edge the distances that w gives to the tie and to the end next to it
inline Lead lead_over(const Window& w, const Window& m, double begin, double end, double tie,
                      double at_tie, double edge, double at_edge) {
  // The difference of two windows is greatest and least at ends, and where their lines coincide.
  const double touch = std::clamp(w.x - w.y * (m.x - w.x) / (m.y - w.y), begin, end);
  const double by_touch = distance_at(w, touch) - distance_at(m, touch);
  const double by_tie = at_tie - distance_at(m, tie), by_edge = at_edge - distance_at(m, edge);
  return {std::min({by_touch, by_tie, by_edge}), std::max({by_touch, by_tie, 0.0})};
}

}  // namespace internal

/// Shortens, drops or merges two neighbours of an edge as described above. When they are merged,
/// the first one becomes the merged one.
/// @param second the neighbour towards the head of the edge
/// @param length of the edge
/// @param rounding of coordinates (trim.h)
inline Joined join(MergedWindow& first, MergedWindow& second, double length, double rounding,
                   const MergeRule& rule) {
  Window &a = first.window, &b = second.window;
  // Of a source on the edge all lines pass one point: they say nothing about an interval.
  if (std::max(a.y, b.y) > -kFlatFace * length) return Joined::neither;
  const double at_begin = distance_at(a, a.begin), at_end = distance_at(b, b.end);
  const double before = double{std::max(first.shortfall, second.shortfall)};
  const double greatest = rule.most * std::min(at_begin, at_end);
  const double most_added = rule.share * (greatest - before);
  const auto rise_to = [&](double t) {  // along the chord
    return at_begin + (at_end - at_begin) * (t - a.begin) / (b.end - a.begin);
  };

  internal::HandOver at{};
  const double begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
  if (end - begin > rounding) {
    const internal::Pair from = internal::pair_at(a, b, begin), to = internal::pair_at(a, b, end);
    const double margin = kPathMargin * from.first + rounding;
    const double g_from = from.first - from.second, g_to = to.first - to.second;
    if (g_from < -margin && g_to > margin) {
      if (b.begin < a.begin || b.end < a.end) return Joined::neither;
      at = internal::crossing_of(a, b, from, to);
      a.end = at.last;
      b.begin = at.next;
    } else if (g_from <= margin && g_to <= margin && internal::is_to_one_side(a, b, begin, end)) {
      if (b.begin < a.begin) {
        if (b.end > a.end) return Joined::neither;
        b.end = begin;
        return is_void(b, length) ? Joined::second_gone : Joined::neither;
      }
      b.begin = end;
      if (b.end <= a.end || is_void(b, length)) return Joined::second_gone;
      at = {end, end, end, to.first, to.second, to.first, to.second};
    } else if (g_from >= -margin && g_to >= -margin && internal::is_to_one_side(b, a, begin, end)) {
      if (a.end > b.end) {
        if (a.begin < b.begin) return Joined::neither;
        a.begin = end;
        return is_void(a, length) ? Joined::first_gone : Joined::neither;
      }
      a.end = begin;
      if (a.begin >= b.begin || is_void(a, length)) return Joined::first_gone;
      at = {begin, begin, begin, from.first, from.second, from.first, from.second};
    } else {
      return Joined::neither;
    }
  } else {
    const bool meet =
        b.begin > a.begin && b.end > a.end && begin <= end + 4 * kWindowWidth * length;
    if (!meet) return Joined::neither;
    at = {a.end,
          b.begin,
          a.end,
          distance_at(a, a.end),
          distance_at(b, b.begin),
          distance_at(a, a.end),
          distance_at(b, a.end)};
  }

  // A merged window is convex: the chord is above it.
  const double at_tie = std::min(at.first_at_tie, at.second_at_tie);
  if (at_tie - rise_to(at.tie) > most_added) return Joined::neither;
  internal::MergedSource source{a.begin, b.end, at_begin, at_end, 0};
  if (!(source.squares() > 0)) return Joined::neither;
  source.away = internal::kFarthest * std::max(at_begin, at_end);
  const auto cosine = [](const Window& w, double t, double distance) {
    return (t - w.x) / (distance - w.sigma);
  };
  source.take_in(std::min(cosine(a, a.begin, at_begin), cosine(b, at.next, at.second_at_next)),
                 std::max(cosine(a, at.last, at.first_at_last), cosine(b, b.end, at_end)));
  source.stay_below(at.tie, at_tie);
  Window m{};
  if (!source.make(m) || m.y > -kLeastAway * length) return Joined::neither;
  const internal::Lead over_a = internal::lead_over(a, m, a.begin, at.last, at.tie, at.first_at_tie,
                                                    at.last, at.first_at_last);
  const internal::Lead over_b = internal::lead_over(b, m, at.next, b.end, at.tie, at.second_at_tie,
                                                    at.next, at.second_at_next);
  const double longer = -std::min(over_a.least, over_b.least);
  if (longer > kPathMargin * std::max(at_begin, at_end)) return Joined::neither;
  const float shortfall = internal::rounded_up(
      std::max(first.shortfall + over_a.greatest, second.shortfall + over_b.greatest));
  const double allowed = rule.most * least_distance(m);
  if (!(shortfall <= allowed && shortfall - before <= rule.share * (allowed - before))) {
    return Joined::neither;
  }
  first = {m, shortfall};
  return Joined::merged;
}

}  // namespace geodesic::edge_based
