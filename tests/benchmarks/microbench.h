// Time per item, and windows and a face for the benchmarks of kernels.
#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/window.h"

namespace geodesic::microbench {

/// Adds the time per item to the time per iteration.
/// @param items number of windows, queue entries, ... of one iteration
inline void report_per_item(benchmark::State& state, const char* counter, std::int64_t items) {
  state.counters[counter] =
      benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}
/// Windows of equal width on an edge of length 1. Their sources lie in order and close together, as
/// after a pencil of windows has passed several saddle vertices.
inline std::vector<Window> windows_in_order(std::size_t count) {
  std::vector<Window> windows;
  const double width = 1 / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = static_cast<double>(i) * width;
    const double x = 0.45 + 0.1 * begin;
    windows.push_back({begin, begin + width, x, -2, 0.01 * std::abs(begin - 0.5)});
  }
  return windows;
}

/// A scalene triangle above the edge of windows_in_order().
inline FaceFrame crossed_face_frame() {
  FaceFrame face{};
  face.length = 1;
  face.apex_x = 0.4;
  face.apex_y = 0.8;
  face.left = std::hypot(face.apex_x, face.apex_y);
  face.right = std::hypot(1 - face.apex_x, face.apex_y);
  face.left_x = face.apex_x / face.left;
  face.left_y = face.apex_y / face.left;
  face.right_x = (1 - face.apex_x) / face.right;
  face.right_y = -face.apex_y / face.right;
  return face;
}

}  // namespace geodesic::microbench
