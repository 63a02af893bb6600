// A window as MMP stores it: 32 bytes in the list of its edge.
//
// The windows of an edge partition it, so that a window ends where the next one begins (the last
// one at the edge's length): a boundary is one number, shared, and no rounding can open or overlap
// it. Parts that nothing has reached yet are windows too, gaps, at infinite distance. Positions are
// in the frame of the half-edge that names the list (edge_lists.h), whichever side a window comes
// from: a source at y < 0 sends its lines into that half-edge's face, at y > 0 into the
// twin's, and at y = 0 along the edge.
//
// Windows of one pseudo-source have their sigma in common. They keep its number instead, which
// leaves room for the event under which a window waits in the queue.
#pragma once

#include <algorithm>
#include <cstddef>

#include "solvers/core/window.h"

namespace geodesic::mmp {

/// @tparam Depth strip depth, an empty type in timed solves (core/recorders.h)
template <class Depth>
struct EdgeWindow {
  double begin;  ///< position on the edge, from the origin of its half-edge
  double x, y;   ///< unfolded position of the (pseudo-)source
  Index source;  ///< its number, by which sigma is found; kNone for a gap
  Index event;   ///< while it waits in the queue, otherwise kNone
  [[no_unique_address]] Depth depth;

  static EdgeWindow gap(double begin) { return {begin, 0, 0, kNone, kNone, {}}; }

  bool is_gap() const { return source == kNone; }
  /// Waits in the queue, not propagated yet.
  bool waits() const { return event != kNone; }

  /// In the kernel's form; y keeps its sign, whichever face the window enters.
  Window geometry(double end, double sigma) const { return {begin, end, x, y, sigma}; }
};

/// What the queue holds, by its number in a Pool, in place of a window or a pseudo-source.
///
/// Windows move within their list and lose parts while they wait. A waiting window has the number
/// of its event and keeps it up to date, so that no entry of the queue has to be searched or
/// replaced then: the entry of a window that is no more is recognised by its cancelled event, and
/// one whose key has grown moves to its new place only when its turn by the old key comes. An event
/// lasts until its entry leaves the queue.
struct Event {
  double begin;    ///< of the window, by which its list finds it; kVertex for a pseudo-source
  double nearest;  ///< position on the edge where the window is nearest, which decides its key
  Index id;        ///< edge or vertex; kNone when the window is no more
  Index index;     ///< of the window in its list when the event was written: near it still
  bool outdated;   ///< the nearest point was lost, the queue has an older and smaller key

  static constexpr double kVertex = -1;
  bool is_cancelled() const { return id == kNone; }
  bool is_window() const { return id != kNone && begin >= 0; }

  /// Where the window lies about now, in its list of `windows`, at least one.
  std::size_t likely_index(std::size_t windows) const {
    return std::min<std::size_t>(index, windows - 1);
  }
};

}  // namespace geodesic::mmp
