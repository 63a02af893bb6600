// The wavefront of a solve at moments of its progress: what recorded solves keep of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solvers/core/window.h"

namespace geodesic {

/// The wavefront distances of the windows on the wavefront at one moment, in the mesh's unit.
struct WavefrontSample {
  Index reached = 0;          ///< vertices that have a finite distance by then
  std::uint64_t windows = 0;  ///< at least one
  double least = kInfinity;
  double mean = 0;
  double sd = 0;  ///< standard deviation

  bool operator==(const WavefrontSample&) const = default;
};

/// A window on the wavefront, as an interval of an edge.
struct WavefrontWindow {
  Index half_edge;    ///< in the mesh's own numbering
  double begin, end;  ///< distances from the half-edge's origin
  double distance;    ///< its wavefront distance: the least over the interval

  bool operator==(const WavefrontWindow&) const = default;
};

/// All windows on the wavefront at the moment of a sample.
struct WavefrontSnapshot {
  double wish;  ///< taken with the first sample that had this share of the reachable vertices
  std::vector<WavefrontWindow> windows;  ///< in no particular order, as many as in the sample

  bool operator==(const WavefrontSnapshot&) const = default;
};

/// @param for_each_window calls its argument as (Index half_edge, const Window&) for every window
///        on the wavefront
template <class ForEachWindow>
WavefrontSample sample_wavefront(Index reached, const ForEachWindow& for_each_window) {
  WavefrontSample sample{.reached = reached};
  double squares = 0;  // of deviations from the mean, by Welford's recurrence
  for_each_window([&](Index, const Window& w) {
    const double distance = least_distance(w);
    const double deviation = distance - sample.mean;
    sample.mean += deviation / static_cast<double>(++sample.windows);
    squares += deviation * (distance - sample.mean);
    sample.least = std::min(sample.least, distance);
  });
  if (sample.windows > 0) sample.sd = std::sqrt(squares / static_cast<double>(sample.windows));
  return sample;
}

}  // namespace geodesic
