// Google Benchmark as functions: they take the work to time and return its repetitions.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/base/json.h"

namespace geodesic::harness {

/// @param flags Google Benchmark's, such as "--benchmark_min_time=0.1"
/// @throws HarnessError for a flag that it does not know, or that would take results away from the
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
  std::function<void()> prepare = {};  ///< before each solve, not timed; may be empty
  bool several_threads = false;        ///< measures wall time, and CPU time of all threads
  /// Times of the last solve if another process did it; otherwise empty.
  std::function<SecondsElsewhere()> elsewhere = {};
};

/// Times as many repetitions as the flags say. @throws the exceptions of the work
std::vector<Repetition> time_repetitions(const std::vector<std::string>& flags,
                                         const TimedWork& work);

/// Google Benchmark's own context keys, without timing anything.
Json benchmark_context();

}  // namespace geodesic::harness
