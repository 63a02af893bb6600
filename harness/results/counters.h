// The counters of a recorded solve, with their names in result files (results/README.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Bytes of a window in the thesis's figures of space (section 5.5.4).
inline constexpr double kThesisWindowBytes = 80;

/// The counters of a solve, and what follows from them.
struct Counters : SolveCounters {
  std::optional<double> strip_b = {};             ///< number of vertices ^ (1 / strip_depth)
  std::optional<double> wavefront_sd_edges = {};  ///< wavefront_sd in mean edge lengths
  std::optional<double> space_thesis_mb = {};     ///< 10^6 bytes, kThesisWindowBytes a window
  std::optional<double> space_mb = {};            ///< 10^6 bytes, window_bytes a window

  bool operator==(const Counters&) const = default;
};

/// Calls `visit(name, member)` for every counter, in the order of result files.
template <class SomeCounters, class Visit>
void for_each_counter(SomeCounters& counters, const Visit& visit) {
  for_each_solve_counter(counters, visit);
  visit("strip_b", counters.strip_b);
  visit("wavefront_sd_edges", counters.wavefront_sd_edges);
  visit("space_thesis_mb", counters.space_thesis_mb);
  visit("space_mb", counters.space_mb);
}

/// The counters of a recorded solve and those derived from them. All numbers are finite.
Counters counters_of(const Recording& recording, const Mesh& mesh);

std::size_t unreachable_vertices(std::span<const double> distances);

}  // namespace geodesic::harness
