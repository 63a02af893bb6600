// Common code of the adapters of Kirsanov's code. libigl has the published version,
// geometry-central a repaired one.
#pragma once

#include "peer.h"

namespace geodesic::peer {

/// @param known facts about the peer, for the remarks
inline Description kirsanov(const std::string& name, const std::string& known) {
  return {.name = name,
          .family = "MMP",
          .paper =
              "Surazhsky, Surazhsky, Kirsanov, Gortler, Hoppe 2005, Fast exact and "
              "approximate geodesics on meshes",
          .exactness = Exactness::bounded,
          // The code drops windows shorter than this share of their edge
          // (SMALLEST_INTERVAL_RATIO). docs/peers.md explains why the share serves as the bound.
          .error_bound = [](const Description&) { return 1e-6; },
          .abilities = {.initial_distances = false, .traces = true},
          .remarks = remarks(known)};
}

/// Records the counters of the code: intervals taken from its queue, and its largest size.
/// @param algorithm object with the members m_iterations and m_queue_max_size
template <class Interval, class Algorithm>
void count(const Algorithm& algorithm, Recording& recording) {
  if (!counts(recording)) return;
  recording.window_propagations = algorithm.m_iterations;
  recording.peak_wavefront = algorithm.m_queue_max_size;
  recording.window_bytes = sizeof(Interval);
}

}  // namespace geodesic::peer
