// What the adapters of Kirsanov's code share: libigl has it as it was published, geometry-central
// with repairs.
#pragma once

#include "peer.h"

namespace geodesic::peer {

/// @param known what is to be known of the peer
inline Description kirsanov(const std::string& name, const std::string& known) {
  return {.name = name,
          .family = "MMP",
          .paper =
              "Surazhsky, Surazhsky, Kirsanov, Gortler, Hoppe 2005, Fast exact and "
              "approximate geodesics on meshes",
          .exactness = Exactness::bounded,
          // Windows of less than this share of their edge are dropped (SMALLEST_INTERVAL_RATIO):
          // docs/peers.md says why that is taken for the bound.
          .error_bound = [](const Description&) { return 1e-6; },
          .abilities = {.initial_distances = false, .traces = true},
          .remarks = remarks(known)};
}

/// What the code counts of a solve: intervals taken from its queue, and the most in it.
/// @param algorithm with the members m_iterations and m_queue_max_size
template <class Interval, class Algorithm>
void count(const Algorithm& algorithm, Recording* recording) {
  if (!counts(recording)) return;
  recording->window_propagations = algorithm.m_iterations;
  recording->peak_wavefront = algorithm.m_queue_max_size;
  recording->window_bytes = sizeof(Interval);
}

}  // namespace geodesic::peer
