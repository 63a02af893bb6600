// What a comparison is not to exceed: `--fail-on time=10%,counters=1%,memory=2%`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/compare/compare.h"

namespace geodesic::harness {

/// Memory may always grow by this much: a table that is doubled once more.
inline constexpr double kMemoryFloor = 65536;  // bytes

/// Largest growth of each kind, as a fraction: 0.1 is 10%. Absent: not looked at.
struct Limits {
  std::optional<double> time = {};      ///< of resolved differences, of cells and of means
  std::optional<double> counters = {};  ///< of integer counters
  std::optional<double> memory = {};    ///< of the solver's peak bytes
};

/// @param words "time=10%", ...
/// @throws HarnessError for anything else
Limits parse_limits(const std::vector<std::string>& words);

/// One line for everything above its limit, and for every cell that was ok and has failed; empty
/// when no limit was asked for.
std::vector<std::string> exceeded(const Comparison& comparison, const Limits& limits);

}  // namespace geodesic::harness
