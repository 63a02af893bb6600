// Time per item beside the time per iteration.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>

namespace geodesic::microbench {

/// @param items windows, queue entries, ... that one iteration deals with
inline void report_per_item(benchmark::State& state, const char* counter, std::int64_t items) {
  state.counters[counter] =
      benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

}  // namespace geodesic::microbench
