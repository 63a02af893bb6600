// A window as MMP stores it: in a pool, known to the list of its edge and to the queue by number.
//
// The windows of an edge partition it (edge_lists.h). Parts that no path has reached yet belong to
// the gap, one window for all edges that every other window beats. Positions are in the frame of
// the half-edge that names the list, whichever side a window comes from: a source at y < 0 sends
// its lines into that half-edge's face, at y > 0 into the twin's, and at y = 0 along the edge.
#pragma once

#include <cstdint>
#include <type_traits>

#include "solvers/core/window.h"

namespace geodesic::mmp {

/// What a number of the pool stands for. Windows in the first two states are in the queue and in a
/// list. The queue alone has the dead ones and the vertices, and releases them.
enum class State : std::uint32_t {
  waits,     ///< to be propagated
  outdated,  ///< waits, but has lost its nearest point: the queue has a smaller key
  done,      ///< has been propagated, or never will be
  dead,      ///< has lost everything while it waited
  gap,       ///< of all edges
  vertex,    ///< no window: the pseudo-source `into`
};

/// The root of a window's lines (LastSegment, core/recording.h), when no paths are recorded.
struct NoRoot {
  NoRoot() = default;
  explicit NoRoot(Index /*root*/) {}
  operator Index() const { return kNone; }  // NOLINT: as an Index
};

/// Data that a window's children inherit, besides the geometry; empty in timed solves.
template <class Recorder>
struct WindowOrigin {
  using Root = std::conditional_t<Recorder::kRemembers, Index, NoRoot>;

  [[no_unique_address]] Root root;
  [[no_unique_address]] typename Recorder::Depth depth;  ///< of the strip of faces

  WindowOrigin next() const { return {root, depth.next()}; }
};

/// @tparam Origin WindowOrigin
template <class Origin>
struct EdgeWindow : Window {
  Index into;  ///< half-edge whose face its lines enter; kNone if they enter none
  State state;
  [[no_unique_address]] Origin origin;

  bool is_queued() const { return state <= State::outdated; }
};

}  // namespace geodesic::mmp
