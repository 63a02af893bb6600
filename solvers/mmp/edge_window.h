// A window as MMP stores it: 32 bytes in the list of its edge.
//
// The windows of an edge partition it. A window ends where the next one begins (the last one at the
// edge's length), so a boundary is one number, and rounding cannot create a gap or an overlap.
// Parts that no path has reached yet are windows too, called gaps, at infinite distance. Positions
// are in the frame of the half-edge that names the list (edge_lists.h), whichever side a window
// comes from: a source at y < 0 sends its lines into that half-edge's face, at y > 0 into the
// twin's, and at y = 0 along the edge.
//
// Windows of one pseudo-source have the same sigma. They store its number instead, which leaves
// room for the number of the event by which a window waits in the queue.
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
  Index source;  ///< number of the (pseudo-)source, which gives sigma; kNone for a gap
  Index event;   ///< its event while it waits in the queue; otherwise kNone
  [[no_unique_address]] Depth depth;

  static EdgeWindow gap(double begin) { return {begin, 0, 0, kNone, kNone, {}}; }

  bool is_gap() const { return source == kNone; }
  /// True for a window in the queue that is not propagated yet.
  bool waits() const { return event != kNone; }

  /// As a Window of the kernel; y keeps its sign, whichever face the window enters.
  Window geometry(double end, double sigma) const { return {begin, end, x, y, sigma}; }
};

/// An entry of the queue, by its number in a Pool: it represents a window or a pseudo-source.
///
/// Windows move within their list and lose parts while they wait. A waiting window stores the
/// number of its event and updates the event, so that no queue entry must be searched or replaced.
/// When a window disappears, its event is cancelled. When its key grows, the entry moves only when
/// its turn by the old key comes. An event exists until its entry leaves the queue.
struct Event {
  double begin;    ///< of the window, to find it in its list; kVertex for a pseudo-source
  double nearest;  ///< position on the edge nearest to the source, which decides the key
  Index id;        ///< edge or vertex; kNone when the window has disappeared
  Index index;     ///< of the window in its list when the event was written; now near it
  bool outdated;   ///< the nearest point was lost: the queue has an older, smaller key

  static constexpr double kVertex = -1;
  bool is_cancelled() const { return id == kNone; }
  bool is_window() const { return id != kNone && begin >= 0; }

  /// Approximate index of the window in its list of `windows` windows; `windows` is at least 1.
  std::size_t likely_index(std::size_t windows) const {
    return std::min<std::size_t>(index, windows - 1);
  }
};

}  // namespace geodesic::mmp
