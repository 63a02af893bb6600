// Where two windows that overlap on an edge give equal distances: the core of MMP's trimming.
//
// Notation: at position t of the edge's line, a window's distance is sigma + |t - I|, with its
// unfolded source I = (x, y). Since y is squared, two windows compare the same whichever side of
// the edge they come from (Liu 2013 keeps both in one list for that reason). The points of equal
// distance lie on a hyperbola with the sources as foci, which the edge's line meets at most twice.
#pragma once

#include <cmath>

#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"

namespace geodesic::mmp {

/// The owners of the parts of an interval: the owner changes at each cut.
struct Division {
  bool challenger_first = false;  ///< owner of the part before the first cut
  int cuts = 0;
  double at[2] = {};  ///< ascending, strictly inside the interval
};

/// Values at both ends of an interval, or the ends themselves, to be computed at once.
using Ends = double __attribute__((vector_size(16)));
inline Ends swapped(Ends a) { return __builtin_shufflevector(a, a, 1, 0); }

/// Bit 0 for the first end, bit 1 for the second.
template <class Mask>
unsigned bits(Mask mask) {
  return (static_cast<unsigned>(mask[0]) & 1) | (static_cast<unsigned>(mask[1]) & 2);
}

/// The distances of a window at both ends of an interval of the edge.
struct EndDistances {
  Ends along;  ///< from the source to the ends, along the edge
  Ends leg;    ///< from the source
  Ends whole;  ///< including sigma

  EndDistances(const Window& w, Ends t)
      : along(t - w.x), leg(root(along * along + w.y * w.y)), whole(leg + w.sigma) {}

 private:
  static Ends root(Ends a) { return Ends{std::sqrt(a[0]), std::sqrt(a[1])}; }
};

/// -1 if the challenger is shorter, 1 if the incumbent is, 0 if they tie.
inline int nearer(double challenger, double incumbent) {
  const double lead = challenger - incumbent, margin = kPathMargin * incumbent;
  return static_cast<int>(lead > margin) - static_cast<int>(lead < -margin);
}

/// Sufficient test that a window that is not shorter at either end of an interval is so nowhere
/// between; it misses few cases. Distances are convex along an edge: the loser's lies above its
/// tangents, the winner's below its chord. Multiplied by the loser's leg to avoid a division.
/// @param width of the interval
inline bool stays_behind(const EndDistances& lost, const EndDistances& won, double width) {
  const Ends towards_the_other_end{width, -width};
  return bits((lost.whole - swapped(won.whole) + kPathMargin * won.whole) * lost.leg +
                  lost.along * towards_the_other_end >=
              0) != 0;
}

/// The part of `divide` for intervals that the ends do not decide.
/// @param at_from, at_to result of `nearer` at the ends of the interval
Division divide_at_intersections(const Window& challenger, const Window& incumbent, double from,
                                 double to, double narrowest, int at_from, int at_to);

/// Divides the interval [from, to] of an edge between two windows: each gets the points where it is
/// shorter. The challenger must be shorter by kPathMargin, relative; the incumbent keeps ties, so
/// of two equal windows exactly one is kept. Source: Surazhsky et al. 2005, section 3.3.
/// @param narrowest parts narrower than this go to their neighbour; unit of length
inline Division divide(const Window& challenger, const Window& incumbent, double from, double to,
                       double narrowest) {
  const EndDistances c(challenger, Ends{from, to}), i(incumbent, Ends{from, to});
  const Ends lead = c.whole - i.whole, margin = kPathMargin * i.whole;
  const unsigned behind = bits(lead > margin), ahead = bits(lead < -margin);
  if (ahead == 0) {
    if (stays_behind(c, i, to - from)) return {};
  } else if (behind == 0) {
    if (stays_behind(i, c, to - from)) return {.challenger_first = true};
  }
  const auto sign = [&](unsigned bit) {
    return static_cast<int>((behind & bit) != 0) - static_cast<int>((ahead & bit) != 0);
  };
  return divide_at_intersections(challenger, incumbent, from, to, narrowest, sign(1), sign(2));
}

/// The positions on the edge's line where two windows give equal distances, ascending, regardless
/// of their intervals. Nearly coinciding windows have none.
struct Crossings {
  int count = 0;
  double at[2] = {};
};
Crossings crossings(const Window& a, const Window& b);

}  // namespace geodesic::mmp
