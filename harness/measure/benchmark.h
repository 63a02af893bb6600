// Google Benchmark as a function: what to time goes in, its own JSON comes out.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/base/json.h"

namespace geodesic::harness {

/// @param flags Google Benchmark's, such as "--benchmark_min_time=0.1"
/// @throws HarnessError for a flag it does not know, or one that would take results away from the
///         run's own files
void check_benchmark_flags(const std::vector<std::string>& flags);

struct Repetition {
  std::int64_t iterations;
  double real_ms, cpu_ms;  ///< of one iteration
};

struct Timing {
  Json context;  ///< Google Benchmark's own keys
  std::vector<Repetition> repetitions;
};

/// Times calls of `solve`, as many repetitions as the flags say. @throws what `solve` throws
Timing time_repetitions(const std::vector<std::string>& flags, const std::function<void()>& solve);

/// Google Benchmark's own context keys, without timing anything.
Json benchmark_context();

}  // namespace geodesic::harness
