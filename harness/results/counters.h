// The counters of a recorded solve, with their names in result files (results/README.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Bytes of a window in the thesis's figures of space (section 5.5.4).
inline constexpr double kThesisWindowBytes = 80;

/// A counter that the solver does not have is empty. Recording (solvers/core/recording.h) defines
/// the members that have no comment here.
struct Counters {
  std::optional<std::uint64_t> window_propagations, windows_created, valid_windows, reinsertions,
      window_limit, peak_wavefront, strip_depth;
  std::optional<double> strip_b = {};  ///< number of vertices ^ (1 / strip_depth)
  std::optional<double> wavefront_sd = {};
  std::optional<double> wavefront_sd_edges = {};  ///< the same in mean edge lengths
  std::optional<std::uint64_t> window_bytes;
  std::optional<double> space_thesis_mb = {};  ///< 10^6 bytes, kThesisWindowBytes a window
  std::optional<double> space_mb = {};         ///< 10^6 bytes, window_bytes a window

  bool operator==(const Counters&) const = default;
};

/// Calls `visit(name, member)` for every counter, in the order of result files. The integers except
/// window_bytes are the same on every run and machine; run.schema.json marks them as `counter`.
template <class SomeCounters, class Visit>
void for_each_counter(SomeCounters& counters, const Visit& visit) {
  visit("window_propagations", counters.window_propagations);
  visit("windows_created", counters.windows_created);
  visit("valid_windows", counters.valid_windows);
  visit("reinsertions", counters.reinsertions);
  visit("window_limit", counters.window_limit);
  visit("peak_wavefront", counters.peak_wavefront);
  visit("strip_depth", counters.strip_depth);
  visit("strip_b", counters.strip_b);
  visit("wavefront_sd", counters.wavefront_sd);
  visit("wavefront_sd_edges", counters.wavefront_sd_edges);
  visit("window_bytes", counters.window_bytes);
  visit("space_thesis_mb", counters.space_thesis_mb);
  visit("space_mb", counters.space_mb);
}

/// The counters of a recorded solve and those derived from them. All numbers are finite.
Counters counters_of(const Recording& recording, const Mesh& mesh);

std::size_t unreachable_vertices(std::span<const double> distances);

}  // namespace geodesic::harness
