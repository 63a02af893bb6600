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

/// The distances of a window at both ends of an interval of the edge.
struct EndDistances {
  double leg_from, leg_to;  ///< from its source
  double from, to;          ///< including sigma

  EndDistances(const Window& w, double t_from, double t_to)
      : leg_from(leg(w, t_from)),
        leg_to(leg(w, t_to)),
        from(w.sigma + leg_from),
        to(w.sigma + leg_to) {}

 private:
  static double leg(const Window& w, double t) {
    const double dx = t - w.x;
    return std::sqrt(dx * dx + w.y * w.y);
  }
};

/// -1 if the challenger is shorter, 1 if the incumbent is, 0 if they tie.
inline int nearer(double challenger, double incumbent) {
  const double lead = challenger - incumbent, margin = kPathMargin * incumbent;
  return static_cast<int>(lead > margin) - static_cast<int>(lead < -margin);
}

/// Sufficient test that a window that is not shorter at either end of an interval is so nowhere
/// between; it misses few cases. Distances are convex along an edge: the loser's lies above its
/// tangents, the winner's below its chord. Multiplied by the loser's leg to avoid a division.
inline bool stays_behind(const Window& loser, const EndDistances& lost, const EndDistances& won,
                         double from, double to) {
  const double width = to - from, tie = kPathMargin * won.from;
  return (lost.from - won.to + tie) * lost.leg_from + (from - loser.x) * width >= 0 ||
         (lost.to - won.from + tie) * lost.leg_to - (to - loser.x) * width >= 0;
}

/// The part of `divide` for intervals that the ends do not decide.
/// @param at_from, at_to result of `nearer` at the ends of the interval
Division divide_at_crossings(Window challenger, Window incumbent, double from, double to,
                             double narrowest, int at_from, int at_to);

/// Divides the interval [from, to] of an edge between two windows: each gets the points where it is
/// shorter. The challenger must be shorter by kPathMargin, relative; the incumbent keeps ties, so
/// of two equal windows exactly one is kept. Source: Surazhsky et al. 2005, section 3.3.
/// @param narrowest parts narrower than this go to their neighbour; unit of length
inline Division divide(const Window& challenger, const Window& incumbent, double from, double to,
                       double narrowest) {
  const EndDistances c(challenger, from, to), i(incumbent, from, to);
  const int at_from = nearer(c.from, i.from), at_to = nearer(c.to, i.to);
  if (at_from >= 0 && at_to >= 0) {
    if (stays_behind(challenger, c, i, from, to)) return {};
  } else if (at_from <= 0 && at_to <= 0) {
    if (stays_behind(incumbent, i, c, from, to)) return {.challenger_first = true};
  }
  return divide_at_crossings(challenger, incumbent, from, to, narrowest, at_from, at_to);
}

/// The positions on the edge's line where two windows give equal distances, ascending, regardless
/// of their intervals. Nearly coinciding windows have none.
struct Crossings {
  int count = 0;
  double at[2] = {};
};
Crossings crossings(const Window& a, const Window& b);

}  // namespace geodesic::mmp
