// Where two windows that overlap on an edge are equally far: the heart of MMP's trimming.
//
// Notation: on the edge's line a window's distance at position t is sigma + |t - I|, I = (x, y) its
// unfolded source. y enters squared, so two windows compare the same whichever side of the edge
// they come from (Liu 2013 keeps both in one list for that reason). The points where two such
// distances are equal lie on a hyperbola with the sources as foci, which the edge's line meets at
// most twice.
#pragma once

#include <cmath>

#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"

namespace geodesic::mmp {

/// Who owns which part of an interval: the owner changes at each cut.
struct Division {
  bool challenger_first = false;  ///< owner of the part before the first cut
  int cuts = 0;
  double at[2] = {};  ///< ascending, strictly inside the interval
};

/// Divides the interval [from, to] of an edge between two windows, to each the points where it is
/// shorter. The challenger has to be shorter by kPathMargin, relative: the incumbent keeps ties, so
/// of two equal windows exactly one is kept. Source: Surazhsky et al. 2005, section 3.3.
/// @param narrowest parts narrower than this go to their neighbour; unit of length
Division divide(const Window& challenger, const Window& incumbent, double from, double to,
                double narrowest);

/// The positions on the edge's line where two windows are equally far, ascending, without regard to
/// their intervals. Nearly coinciding windows have none.
struct Crossings {
  int count = 0;
  double at[2] = {};
};
Crossings crossings(const Window& a, const Window& b);

}  // namespace geodesic::mmp
