// The steps of a crossing over whole lists, window by window. They are the kernels of processors
// without AVX2, and state what the vector kernels (kernels-inl.h) compute: both give the same bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solvers/core/tolerance.h"
#include "solvers/core/window_predicates.h"
#include "solvers/edge_based/batch.h"
#include "solvers/edge_based/kernels.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based::plain {

/// Takes the windows that no path over an end of the edge beats (the filter of Xin and Wang 2009).
inline void gather(const Segment& segment, const EndpointBounds& bounds, Batch& batch) {
  batch.reserve(batch.count + segment.count);
  for (std::size_t i = 0; i < segment.count; ++i) {
    if (bounds.beat(window_of(segment, i))) continue;
    for (unsigned f = 0; f < batch.fields(); ++f) batch.array(f)[batch.count] = segment.array(f)[i];
    ++batch.count;
  }
}

/// Strategy I for window i: trims it against the windows before it, from the nearest one on, until
/// one of them remains in part or lies before it.
/// @return whether window i has changed
[[gnu::always_inline]] inline bool trim_against_earlier(Batch& batch, std::size_t i,
                                                        const EdgeBelow& edge) {
  const Window original = batch.window(i);
  Window second = original;
  bool keeps = true;
  for (std::size_t before = i; keeps && before-- > 0;) {
    if (batch.is_struck_out(before)) continue;
    Window first = batch.window(before);
    if (first.begin <= second.begin && first.end <= second.end) break;
    trim_pair(first, second, edge);
    keeps = !is_void(second, edge.length);
    if (batch.put_back(before, first, edge.length)) break;
  }
  batch.put_back(i, second, edge.length);
  return !keeps || second.begin != original.begin || second.end != original.end;
}

/// Strategy I: trims windows that are out of order with their neighbour, and those after a window
/// that has changed.
inline void trim(Batch& batch, const EdgeBelow& edge) {
  Window neighbour{};
  bool has_changed = false;  // the neighbour
  for (std::size_t i = 1; i < batch.count; ++i) {
    // The neighbours of a block are compared as they are before any of them is trimmed.
    if ((i - 1) % kTrimmedAtOnce == 0) {
      neighbour = batch.window(i - 1);
      has_changed = false;
    }
    const Window w = batch.window(i);
    has_changed =
        (has_changed || out_of_order(neighbour, w)) && trim_against_earlier(batch, i, edge);
    neighbour = w;
  }
}

// Marks have a byte for each window here, since a vector is one window.

/// Marks the sides on which the lines of each window pass the apex.
/// @return the window that reaches the apex at the least distance, without its position
inline ApexWinner classify(Batch& batch, const FaceFrame& face) {
  std::uint8_t* passes_left = batch.passes_left.groups();
  std::uint8_t* passes_right = batch.passes_right.groups();
  ApexWinner best;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Window w = batch.window(i);
    const WindowSight sight(w, {face.apex_x, face.apex_y});
    const Sides seen = sight.sides();
    passes_left[i] = seen.left;
    passes_right[i] = seen.right;
    if ((!seen.left && !seen.right) || !sight.reaches()) continue;
    const double distance = distance_to_apex(w, seen, face);
    if (distance < best.distance) {
      best.window = i;
      best.distance = distance;
    }
  }
  return best;
}

/// Marks the windows that Strategy II decides (sides_kept): other windows of both sides, and
/// windows that pass it on one side and start on the other side of the winner's line.
/// @return whether there are any
inline bool find_contested(Batch& batch, const ApexWinner& winner) {
  bool any = false;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const bool left = batch.passes_left.groups()[i] != 0;
    const bool right = batch.passes_right.groups()[i] != 0;
    const bool beyond = batch.array(kBegin)[i] >= winner.position;
    const bool before = batch.array(kEnd)[i] <= winner.position;
    const bool contested = i != winner.window && ((left && (right || beyond)) || (right && before));
    batch.contested.groups()[i] = contested;
    any |= contested;
  }
  return any;
}

/// Appends window i of the batch, as it is in the frame of the edge that it leaves a face through.
inline void append(const Batch& batch, std::size_t i, const Window& unfolded, double length,
                   Segment& to) {
  if (is_void(unfolded, length)) return;
  for (unsigned f = kRoot; f < batch.fields(); ++f) {
    to.array(f)[to.count] = batch.array(f)[i] + (f == kDepth ? 1 : 0);
  }
  to.add(unfolded);
}

inline void unfold_marked(const Batch& batch, const FaceFrame& face, const Marks& to_left,
                          const Marks& to_right, Segment& left, Segment& right) {
  left.count = right.count = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Window w = batch.window(i);
    const bool passes_left = batch.passes_left.groups()[i] != 0;
    const bool passes_right = batch.passes_right.groups()[i] != 0;
    if (to_left.groups()[i] != 0) {
      append(batch, i, face.left_child(w, passes_right), face.left, left);
    }
    if (to_right.groups()[i] != 0) {
      append(batch, i, face.right_child(w, passes_left), face.right, right);
    }
  }
}

inline ApexWinner unfold(Batch& batch, const FaceFrame& face, Segment& left, Segment& right) {
  ApexWinner best = classify(batch, face);
  if (best.window != SIZE_MAX) best.position = apex_line_in(batch.window(best.window), face);
  unfold_marked(batch, face, batch.passes_left, batch.passes_right, left, right);
  best.is_contested = best.window != SIZE_MAX && find_contested(batch, best);
  return best;
}

inline constexpr Kernels kKernels = {1, gather, trim, unfold, unfold_marked};

}  // namespace geodesic::edge_based::plain
