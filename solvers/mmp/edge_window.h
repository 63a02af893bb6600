// A window as MMP stores it: 32 bytes in the list of its edge.
//
// The windows of an edge partition it, so that a window ends where the next one begins (the last
// one at the edge's length): a boundary is one number, shared, and no rounding can open or overlap
// it. Parts that nothing has reached yet are windows too, gaps, at infinite distance. Positions are
// in the frame of the half-edge that the list goes by (list_layout.h), whichever side a window
// comes from: a source at y < 0 sends its lines into that half-edge's face, at y > 0 into the
// twin's, and at y = 0 along the edge.
//
// Windows of one pseudo-source have their sigma in common. They keep its number instead, which
// leaves room for the ticket under which a window waits in the queue (tickets.h).
#pragma once

#include "solvers/core/window.h"

namespace geodesic::mmp {

/// @tparam Depth strip depth, an empty type in timed solves (core/recording.h)
template <class Depth>
struct EdgeWindow {
  double begin;  ///< position on the edge, from the origin of its half-edge
  double x, y;   ///< unfolded position of the (pseudo-)source
  Index source;  ///< its number, by which sigma is found; kNone for a gap
  Index ticket;  ///< while it waits in the queue, otherwise kNone
  [[no_unique_address]] Depth depth;

  static EdgeWindow gap(double begin) { return {begin, 0, 0, kNone, kNone, {}}; }

  bool is_gap() const { return source == kNone; }
  /// Waits in the queue, not propagated yet.
  bool waits() const { return ticket != kNone; }

  /// In the kernel's form; y keeps its sign, whichever face the window enters.
  Window geometry(double end, double sigma) const { return {begin, end, x, y, sigma}; }
};

}  // namespace geodesic::mmp
