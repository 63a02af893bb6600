// What a recorded solve counts, and the recorders a solver's inner loop is compiled against.
//
// A solver is written as a template over its recorder. `NoRecorder` is empty: timed solves contain
// no trace of it. `CountingRecorder` fills a Recording with counters, `WavefrontRecorder` keeps the
// samples of the wavefront besides; `TimingRecorder` counts nothing, which would take time, and
// reads the clock instead. Definitions: docs/metrics.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/core/final_windows.h"
#include "solvers/core/phase_timer.h"
#include "solvers/core/sweep.h"
#include "solvers/core/wavefront_samples.h"

namespace geodesic {

/// What a recorded solve is made for.
enum class Record : std::uint8_t {
  counters,
  phase_times,  ///< and nothing else
  wavefront,    ///< and counters
  windows,      ///< those that the solve ends with, and nothing else
};

/// Integer results are the same on every run and every x86-64 machine.
struct Recording {
  Record what = Record::counters;  ///< the caller's wish
  /// Of Record::wavefront: when to take snapshots, as shares of the reachable vertices, ascending.
  std::vector<double> snapshots_at = {};
  /// Of Record::windows: called once, when the solve is over, by solvers that keep them
  /// (Description::final_windows).
  const ReadWindows* read_windows = nullptr;

  std::optional<std::uint64_t> window_propagations;  ///< windows propagated across a face
  std::optional<std::uint64_t> windows_created;      ///< before reduction drops any; not in MMP
  std::optional<std::uint64_t> valid_windows;        ///< windows that survive redundancy reduction
  std::optional<std::uint64_t> reinsertions;         ///< MMP only: contained in the two above
  std::optional<std::uint64_t> window_limit;         ///< MMP only: windows on all edges at the end
  std::optional<std::uint64_t> peak_wavefront;  ///< most windows on the wavefront at any moment
  std::optional<std::uint64_t> strip_depth;     ///< longest chain of faces a window crossed
  std::optional<std::uint64_t> window_bytes;    ///< size of one stored window
  std::optional<double> wavefront_sd;           ///< mean over samples, in units of length

  std::optional<PhaseTimes> phase_times;

  std::vector<WavefrontSample> curve = {};        ///< at equal steps of progress (sweep.h)
  std::vector<WavefrontSnapshot> snapshots = {};  ///< the wished ones that came about

  bool operator==(const Recording&) const = default;
};

/// The length of a window's strip of faces; an empty type when nothing is recorded.
struct NoDepth {
  NoDepth next() const { return {}; }
};
/// The same where it is counted.
struct StripDepth {
  std::uint32_t faces = 0;
  StripDepth next() const { return {faces + 1}; }
};

/// What only recorded solves count is of these types, so that a timed solve that touched any of it
/// would not compile.
struct NoSweep {};
struct NoCount {};

/// Of timed solves: records nothing and costs nothing.
struct NoRecorder {
  static constexpr bool kRecords = false;
  using Depth = NoDepth;
  using Sweep = NoSweep;
  using Count = NoCount;

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

/// Reads the clock whenever the phase changes, and counts nothing.
struct TimingRecorder : NoRecorder {
  explicit TimingRecorder(PhaseTimer& into) : timer(into) {}
  PhaseScope<PhaseTimer> enter(Phase phase) const { return {timer, phase}; }

  PhaseTimer& timer;
};

/// Fills a Recording with counters.
struct CountingRecorder {
  static constexpr bool kRecords = true;
  using Depth = StripDepth;
  using Sweep = geodesic::Sweep;
  using Count = std::uint64_t;

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

  /// Samples the wavefront, at every step of progress.
  /// @param for_each_window as in wavefront_samples.h
  template <class ForEachWindow>
  WavefrontSample sample(const Sweep& sweep, const ForEachWindow& for_each_window) {
    const WavefrontSample sample = sample_wavefront(sweep.reached(), for_each_window);
    if (sample.windows == 0) return sample;
    sd_sum_ += sample.sd;
    recording.wavefront_sd = sd_sum_ / ++samples_;
    return sample;
  }

  NoRecorder::NoScope enter(Phase /*phase*/) const { return {}; }

  Recording& recording;

 private:
  double sd_sum_ = 0;
  int samples_ = 0;
};

/// Counts, and keeps samples and snapshots of the wavefront.
struct WavefrontRecorder : CountingRecorder {
  using CountingRecorder::CountingRecorder;

  /// As above, and keeps the sample; a wavefront without windows has none.
  template <class ForEachWindow>
  void sample(const Sweep& sweep, const ForEachWindow& for_each_window) {
    const WavefrontSample sample = CountingRecorder::sample(sweep, for_each_window);
    if (sample.windows == 0) return;
    recording.curve.push_back(sample);
    for (std::size_t next = recording.snapshots.size();
         next < recording.snapshots_at.size() && sweep.share() >= recording.snapshots_at[next];
         ++next) {
      take_snapshot(recording.snapshots_at[next], for_each_window);
    }
  }

 private:
  template <class ForEachWindow>
  void take_snapshot(double wish, const ForEachWindow& for_each_window) {
    WavefrontSnapshot snapshot{.wish = wish, .windows = {}};
    for_each_window([&](Index half_edge, const Window& w) {
      snapshot.windows.push_back({half_edge, w.begin, w.end, least_distance(w)});
    });
    recording.snapshots.push_back(std::move(snapshot));
  }
};

/// Calls `solve` with the recorder for what `recording` wants.
template <class Solve>
void solve_recording(Recording& recording, Solve&& solve) {
  if (recording.what == Record::counters) return solve(CountingRecorder(recording));
  if (recording.what == Record::wavefront) return solve(WavefrontRecorder(recording));
  PhaseTimer timer;
  solve(TimingRecorder(timer));
  recording.phase_times = timer.times();
}

}  // namespace geodesic
