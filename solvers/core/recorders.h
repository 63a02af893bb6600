// The recorders that a solver's inner loop is compiled against.
//
// A solver is a template over its recorder. `NoRecorder` is empty and leaves no trace in timed
// solves. `CountingRecorder` fills a Recording with counters. `WavefrontRecorder` also keeps
// samples of the wavefront. `TimingRecorder` reads the clock; it counts nothing, since counting
// takes time. `PathRecorder` records the last segments of paths.
//
// The rest of a file changes what the compiler inlines into a timed solve, by 1% to 3% of its
// instructions. Each family therefore defines its recorded solves in a header of their own,
// recorded.h, which FAMILY_recorded.cpp instantiates and variants include.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "solvers/core/last_segments.h"
#include "solvers/core/progress.h"
#include "solvers/core/recording.h"

namespace geodesic {

/// @param for_each_window calls its argument as (Index half_edge, const Window&) for every window
///        on the wavefront
template <class ForEachWindow>
WavefrontSample sample_wavefront(Index reached, const ForEachWindow& for_each_window) {
  WavefrontSample sample{.reached = reached};
  double squares = 0;  // of deviations from the mean, by Welford's recurrence
  for_each_window([&](Index, const Window& w) {
    const double distance = least_distance(w);
    const double deviation = distance - sample.mean;
    sample.mean += deviation / static_cast<double>(++sample.windows);
    squares += deviation * (distance - sample.mean);
    sample.least = std::min(sample.least, distance);
  });
  if (sample.windows > 0) sample.sd = std::sqrt(squares / static_cast<double>(sample.windows));
  return sample;
}

/// Number of faces in a window's strip.
struct StripDepth {
  std::uint32_t faces = 0;
  StripDepth next() const { return {faces + 1}; }
};

// The types of data that only recorded solves keep, as timed solves have them: empty. They can be
// changed like the data, but not read.

/// As StripDepth.
struct NoDepth {
  constexpr NoDepth() = default;
  constexpr NoDepth(StripDepth /*depth*/) {}  // NOLINT: as a depth
  constexpr NoDepth next() const { return {}; }
};

/// As LastSegment.
struct NoLastSegment {
  constexpr NoLastSegment(Index /*half_edge*/, Index /*root*/, const Point2& /*from*/) {}
  constexpr NoLastSegment(const LastSegment& /*segment*/) {}  // NOLINT: as a segment
};

/// As a number of windows.
struct NoCount {
  constexpr NoCount() = default;
  constexpr NoCount(std::uint64_t /*windows*/) {}  // NOLINT: as a number
  constexpr NoCount& operator++() { return *this; }
  constexpr NoCount& operator--() { return *this; }
  constexpr NoCount& operator+=(std::uint64_t /*windows*/) { return *this; }
};

/// As Progress.
struct NoProgress {
  constexpr void start(const Mesh& /*mesh*/, const Start& /*start*/) {}
  constexpr void improved(double /*former*/) {}
  constexpr bool made_step() const { return false; }
};

/// The type of last segments in a solver with this recorder.
template <class Recorder>
using LastSegmentOf = std::conditional_t<Recorder::kRemembers, LastSegment, NoLastSegment>;

/// The recorder of timed solves: records nothing and costs nothing.
struct NoRecorder {
  static constexpr bool kRecords = false;
  static constexpr bool kRemembers = false;
  using Depth = NoDepth;
  using Progress = NoProgress;
  using Count = NoCount;

  // As those of CountingRecorder.
  constexpr void window_bytes(std::size_t /*bytes*/) {}
  constexpr void propagated(std::uint64_t /*windows*/, Depth /*deepest*/) {}
  constexpr void created(std::uint64_t /*windows*/) {}
  constexpr void valid(std::uint64_t /*windows*/) {}
  constexpr void reinserted(std::uint64_t /*windows*/) {}
  constexpr void wavefront_size(Count /*windows*/) {}
  template <class ForEachWindow>
  constexpr void sample(Progress /*progress*/, const ForEachWindow& /*for_each_window*/) {}

  // As those of PathRecorder.
  constexpr void arrived(Index /*v*/, NoLastSegment /*last_segment*/) {}
  constexpr void crosses(Index /*h*/, const Window& /*w*/, Index /*root*/) {}
  template <class ForEachWindow>
  constexpr void crosses(Index /*h*/, const ForEachWindow& /*for_each_window*/) {}

  /// The given phase runs during the lifetime of the result (phase_timer.h).
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
struct CountingRecorder : NoRecorder {
  static constexpr bool kRecords = true;
  using Depth = StripDepth;
  using Progress = geodesic::Progress;
  using Count = std::uint64_t;

  explicit CountingRecorder(Recording& into) : recording(into) {
    recording.window_propagations = recording.valid_windows = recording.peak_wavefront =
        recording.strip_depth = 0;
  }

  /// A stored window has `bytes` bytes.
  void window_bytes(std::size_t bytes) { recording.window_bytes = bytes; }
  /// `windows` windows were propagated across one face. `deepest` is the longest strip among them,
  /// this face included.
  void propagated(std::uint64_t windows, Depth deepest) {
    *recording.window_propagations += windows;
    *recording.strip_depth = std::max<std::uint64_t>(*recording.strip_depth, deepest.faces);
  }
  /// `windows` windows were created, before filtering.
  void created(std::uint64_t windows) {
    recording.windows_created = recording.windows_created.value_or(0) + windows;
  }
  /// `windows` windows survived redundancy reduction.
  void valid(std::uint64_t windows) { *recording.valid_windows += windows; }
  /// `windows` waiting windows were trimmed and queued again. Each counts as a window of its own
  /// (thesis 5.5.1, item 1).
  void reinserted(std::uint64_t windows) {
    recording.reinsertions = recording.reinsertions.value_or(0) + windows;
    *recording.window_propagations += windows;
    *recording.valid_windows += windows;
  }
  /// The wavefront now has `windows` windows.
  void wavefront_size(std::uint64_t windows) {
    *recording.peak_wavefront = std::max(*recording.peak_wavefront, windows);
  }

  /// Samples the wavefront; called at every step of progress.
  /// @param for_each_window as in sample_wavefront
  template <class ForEachWindow>
  WavefrontSample sample(const Progress& progress, const ForEachWindow& for_each_window) {
    const WavefrontSample sample = sample_wavefront(progress.reached(), for_each_window);
    if (sample.windows == 0) return sample;
    sd_sum_ += sample.sd;
    recording.wavefront_sd = sd_sum_ / ++samples_;
    return sample;
  }

  Recording& recording;

 private:
  double sd_sum_ = 0;
  int samples_ = 0;
};

/// Counts, and keeps samples and snapshots of the wavefront.
struct WavefrontRecorder : CountingRecorder {
  /// @param distances the solver's, which it changes
  WavefrontRecorder(Recording& into, std::span<const double> distances)
      : CountingRecorder(into), distances_(distances) {
    recording.reached_by.assign(distances.size(), kNone);
  }

  /// As CountingRecorder's, and keeps the sample; a wavefront without windows gives none.
  template <class ForEachWindow>
  void sample(const Progress& progress, const ForEachWindow& for_each_window) {
    const WavefrontSample sample = CountingRecorder::sample(progress, for_each_window);
    if (sample.windows == 0) return;
    note_reached();
    recording.curve.push_back(sample);
    for (std::size_t next = recording.snapshots.size();
         next < recording.snapshots_at.size() && progress.share() >= recording.snapshots_at[next];
         ++next) {
      take_snapshot(recording.snapshots_at[next], for_each_window);
    }
  }

 private:
  void note_reached() {
    const auto number = static_cast<Index>(recording.curve.size());
    for (Index v = 0; v < distances_.size(); ++v) {
      Index& by = recording.reached_by[v];
      if (by == kNone && distances_[v] < kInfinity) by = number;
    }
  }

  template <class ForEachWindow>
  void take_snapshot(double share, const ForEachWindow& for_each_window) {
    WavefrontSnapshot snapshot{.share = share, .windows = {}};
    for_each_window([&](Index half_edge, const Window& w) {
      snapshot.windows.push_back({half_edge, w.begin, w.end, least_distance(w)});
    });
    recording.snapshots.push_back(std::move(snapshot));
  }

  std::span<const double> distances_;
};

/// Records the last segments of paths. A solver with this recorder stores the root of every window.
struct PathRecorder : NoRecorder {
  static constexpr bool kRemembers = true;
  using Depth = StripDepth;

  void propagated(std::uint64_t /*windows*/, Depth /*deepest*/) {}
  explicit PathRecorder(LastSegments& into) : segments(into) {}
  /// Call whenever a vertex gets a new distance.
  void arrived(Index v, const LastSegment& last_segment) { segments.arrived(v, last_segment); }
  /// Call for every window that crosses the face of h, before other windows of its edge trim it.
  /// @param w in the frame of h; @param root as in LastSegment
  void crosses(Index h, const Window& w, Index root) { segments.crosses(h, w, root); }
  /// The same for several windows.
  /// @param for_each_window calls its argument as (const Window&, Index root)
  template <class ForEachWindow>
  void crosses(Index h, const ForEachWindow& for_each_window) {
    segments.crosses(h, for_each_window);
  }

  LastSegments& segments;
};

/// Calls `solve` with the recorder for `recording.kind`.
/// @param distances filled by `solve`
template <class Solve>
void solve_recording(const Mesh& mesh, const InternalQuery& query,
                     std::span<const double> distances, Recording& recording, Solve&& solve) {
  if (recording.kind == RecordingKind::paths) {
    LastSegments segments(mesh, query, recording.keeps_windows);
    solve(PathRecorder(segments));
    return segments.finish(distances, recording);
  }
  if (recording.kind == RecordingKind::counters) return solve(CountingRecorder(recording));
  if (recording.kind == RecordingKind::wavefront) {
    return solve(WavefrontRecorder(recording, distances));
  }
  PhaseTimer timer;
  solve(TimingRecorder(timer));
  recording.phase_times = timer.times();
}

}  // namespace geodesic
