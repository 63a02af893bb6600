// What a recorded solve counts, and the recorders a solver's inner loop is compiled against.
//
// A solver is written as a template over its recorder. `NoRecorder` is empty: timed solves contain
// no trace of it. `CountingRecorder` fills a Recording with counters; `TimingRecorder` counts
// nothing, which would take time, and reads the clock instead. Definitions: docs/metrics.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "solvers/core/phase_timer.h"

namespace geodesic {

/// What a recorded solve is made for.
enum class Record : std::uint8_t { counters, phase_times };

/// Integer results are the same on every run and every x86-64 machine.
struct Recording {
  Record what = Record::counters;  ///< the caller's wish

  std::optional<std::uint64_t> window_propagations;  ///< windows propagated across a face
  std::optional<std::uint64_t> windows_created;      ///< before reduction drops any; not in MMP
  std::optional<std::uint64_t> valid_windows;        ///< windows that survive redundancy reduction
  std::optional<std::uint64_t> reinsertions;         ///< MMP only: contained in the two above
  std::optional<std::uint64_t> window_limit;         ///< MMP only: windows on all edges at the end
  std::optional<std::uint64_t> peak_wavefront;  ///< most windows on the wavefront at any moment
  std::optional<std::uint64_t> strip_depth;     ///< longest chain of faces a window crossed
  std::optional<std::uint64_t> window_bytes;    ///< size of one stored window
  std::optional<double> wavefront_sd;           ///< mean over samples, in units of length

  std::optional<PhaseTimes> phase_times;  ///< when they are wished for: the only thing recorded

  bool operator==(const Recording&) const = default;
};

/// The length of a window's strip of faces; an empty type when nothing is recorded.
struct NoDepth {
  NoDepth next() const { return {}; }
};
struct StripDepth {
  std::uint32_t faces = 0;
  StripDepth next() const { return {faces + 1}; }
};

struct NoRecorder {
  static constexpr bool kRecords = false;
  using Depth = NoDepth;

  void propagated(std::uint64_t /*windows*/, Depth /*deepest*/) {}
  void created(std::uint64_t /*windows*/) {}
  void valid(std::uint64_t /*windows*/) {}
  void reinserted(std::uint64_t /*windows*/) {}
  void wavefront_size(std::uint64_t /*windows*/) {}

  /// The phase that runs as long as the result lives (phase_timer.h).
  struct [[nodiscard]] NoScope {
    constexpr ~NoScope() {}  // NOLINT: a result without a destructor would be called unused
  };
  constexpr NoScope enter(Phase /*phase*/) const { return {}; }
};

struct TimingRecorder : NoRecorder {
  explicit TimingRecorder(PhaseTimer& into) : timer(into) {}
  PhaseScope<PhaseTimer> enter(Phase phase) const { return {timer, phase}; }

  PhaseTimer& timer;
};

struct CountingRecorder {
  static constexpr bool kRecords = true;
  using Depth = StripDepth;

  explicit CountingRecorder(Recording& into) : recording(into) {
    recording.window_propagations = recording.valid_windows = recording.peak_wavefront =
        recording.strip_depth = 0;
  }

  /// `windows` windows were propagated across one face; the longest strip among them is `deepest`,
  /// this face included.
  void propagated(std::uint64_t windows, Depth deepest) {
    *recording.window_propagations += windows;
    *recording.strip_depth = std::max<std::uint64_t>(*recording.strip_depth, deepest.faces);
  }
  /// `windows` windows were made, and go through the filter next.
  void created(std::uint64_t windows) {
    recording.windows_created = recording.windows_created.value_or(0) + windows;
  }
  /// `windows` windows survived redundancy reduction.
  void valid(std::uint64_t windows) { *recording.valid_windows += windows; }
  /// `windows` windows that waited in the queue were trimmed and queued anew, which counts as
  /// windows of their own (thesis 5.5.1, item 1).
  void reinserted(std::uint64_t windows) {
    recording.reinsertions = recording.reinsertions.value_or(0) + windows;
    *recording.window_propagations += windows;
    *recording.valid_windows += windows;
  }
  /// The wavefront now holds this many windows.
  void wavefront_size(std::uint64_t windows) {
    *recording.peak_wavefront = std::max(*recording.peak_wavefront, windows);
  }

  /// Adds one sample of the wavefront: the standard deviation of its windows' distances.
  void wavefront_sample(double sum, double sum_of_squares, std::uint64_t windows) {
    if (windows == 0) return;
    const double n = static_cast<double>(windows);
    const double mean = sum / n;
    sd_sum_ += std::sqrt(std::max(0.0, sum_of_squares / n - mean * mean));
    recording.wavefront_sd = sd_sum_ / ++samples_;
  }

  NoRecorder::NoScope enter(Phase /*phase*/) const { return {}; }

  Recording& recording;

 private:
  double sd_sum_ = 0;
  int samples_ = 0;
};

/// Calls `solve` with the recorder for what `recording` wants.
template <class Solve>
void solve_recording(Recording& recording, Solve&& solve) {
  if (recording.what == Record::counters) return solve(CountingRecorder(recording));
  PhaseTimer timer;
  solve(TimingRecorder(timer));
  recording.phase_times = timer.times();
}

}  // namespace geodesic
