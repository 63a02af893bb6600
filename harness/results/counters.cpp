#include "harness/results/counters.h"

#include <algorithm>
#include <cmath>

namespace geodesic::harness {

Counters counters_of(const Recording& recording, const Mesh& mesh) {
  Counters counters{recording};
  if (recording.strip_depth.value_or(0) > 0) {
    counters.strip_b =
        std::pow(mesh.vertex_count(), 1 / static_cast<double>(*recording.strip_depth));
  }
  if (recording.wavefront_sd && !std::isfinite(*recording.wavefront_sd)) {
    counters.wavefront_sd.reset();
  }
  if (counters.wavefront_sd && mesh.mean_edge_length() > 0) {
    counters.wavefront_sd_edges = *counters.wavefront_sd / mesh.mean_edge_length();
  }
  // Space by the thesis's rule: windows left at the end for MMP, the only solver with a window
  // limit, and the peak of the wavefront for all others.
  const auto& windows = recording.window_limit ? recording.window_limit : recording.peak_wavefront;
  if (windows) {
    constexpr double kMegabyte = 1e6;
    const auto count = static_cast<double>(*windows);
    counters.space_thesis_mb = count * kThesisWindowBytes / kMegabyte;
    if (recording.window_bytes) {
      counters.space_mb = count * static_cast<double>(*recording.window_bytes) / kMegabyte;
    }
  }
  return counters;
}

std::size_t unreachable_vertices(std::span<const double> distances) {
  return static_cast<std::size_t>(std::count(distances.begin(), distances.end(), kInfinity));
}

}  // namespace geodesic::harness
