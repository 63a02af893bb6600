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

struct SecondsElsewhere {
  double real, cpu;
};

struct TimedWork {
  std::function<void()> solve;
  std::function<void()> prepare = {};  ///< before each solve, not timed; may be absent
  bool several_threads = false;        ///< wall time counts, CPU time is that of all threads
  /// Of the last solve, where another process did it; otherwise absent.
  std::function<SecondsElsewhere()> elsewhere = {};
};

/// Times the work, as many repetitions as the flags say. @throws what it throws
std::vector<Repetition> time_repetitions(const std::vector<std::string>& flags,
                                         const TimedWork& work);

/// Google Benchmark's own context keys, without timing anything.
Json benchmark_context();

}  // namespace geodesic::harness
