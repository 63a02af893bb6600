// The counters, times and samples of a recorded solve, as plain data. Definitions: docs/metrics.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "solvers/core/phase_timer.h"
#include "solvers/core/window.h"

namespace geodesic {

class FaceWindows;

/// Wavefront distances of all windows on the wavefront at one moment, in the mesh's unit.
struct WavefrontSample {
  Index reached = 0;          ///< vertices with a finite distance at that moment
  std::uint64_t windows = 0;  ///< at least one
  double least = kInfinity;
  double mean = 0;
  double sd = 0;  ///< standard deviation

  bool operator==(const WavefrontSample&) const = default;
};

/// A window on the wavefront, as an interval of an edge.
struct WavefrontWindow {
  Index half_edge;    ///< in the mesh's internal numbering
  double begin, end;  ///< distances from the half-edge's origin
  double distance;    ///< wavefront distance: the least distance over the interval

  bool operator==(const WavefrontWindow&) const = default;
};

/// All windows on the wavefront at the moment of a sample.
struct WavefrontSnapshot {
  double share;  ///< of the reachable vertices: taken with the first sample that has this share
  std::vector<WavefrontWindow> windows;  ///< in no particular order; as many as in the sample

  bool operator==(const WavefrontSnapshot&) const = default;
};

/// Returns the windows that determine the distance along an edge, in order and without overlap.
/// Parts of the edge that no window reached are left out. The frame is that of the smaller of the
/// twins. Lines go on into its face where y < 0, into the other twin's face where y > 0, and along
/// the edge where y = 0. The function is valid only during the call that passes it.
/// @param half_edge either twin, in the mesh's internal numbers
/// @param windows overwritten
using FinalWindows = std::function<void(Index half_edge, std::vector<Window>& windows)>;

/// Reads the final windows of a solve (Recording::read_windows).
using ReadWindows = std::function<void(const FinalWindows&)>;

/// The last straight segment of the shortest path to a vertex or target.
struct LastSegment {
  /// Half-edge whose face contains the end of the segment: for a vertex, its apex. kNone at a
  /// source and where no path leads.
  Index half_edge = kNone;
  /// Start of the segment: a vertex; or the number of vertices plus i, for source i of the query on
  /// an edge or in a face. At a source it is the vertex itself, kNone where no path leads.
  Index root = kNone;
  /// Position of the root, unfolded along the segment into the frame of `half_edge`. y <= 0, unless
  /// the root lies in the same face.
  Point2 from = {0, 0};

  bool operator==(const LastSegment&) const = default;
};

/// Distance of a target of the query, as exact as that of a vertex wherever the target lies, and
/// its last segment.
struct AtTarget {
  double distance = kInfinity;
  LastSegment last_segment = {};

  bool operator==(const AtTarget&) const = default;
};

/// What a recorded solve records.
enum class RecordingKind : std::uint8_t {
  counters,
  phase_times,  ///< nothing else
  wavefront,    ///< with counters
  windows,      ///< the windows at the end of the solve, nothing else
  paths,        ///< the last segments of paths, nothing else
};

/// What a solve counts; empty where the solver does not count it. The integers but `window_bytes`
/// are the same in every run and on every machine. results/run.schema.json has their names too.
struct SolveCounters {
  std::optional<std::uint64_t> window_propagations;  ///< windows propagated across a face
  std::optional<std::uint64_t> windows_created;      ///< before redundancy reduction; not in MMP
  std::optional<std::uint64_t> valid_windows;        ///< windows that survive redundancy reduction
  std::optional<std::uint64_t> reinsertions;         ///< MMP only: counted as propagated and valid
  std::optional<std::uint64_t> window_limit;         ///< MMP only: windows on all edges at the end
  std::optional<std::uint64_t> peak_wavefront;  ///< most windows on the wavefront at any moment
  std::optional<std::uint64_t> strip_depth;     ///< longest chain of faces a window crossed
  std::optional<std::uint64_t> window_bytes;    ///< size of one stored window
  std::optional<double> wavefront_sd;           ///< mean over samples, in units of length

  bool operator==(const SolveCounters&) const = default;
};

/// Calls `visit(name, member)` for each of these counters.
template <class SomeCounters, class Visit>
void for_each_solve_counter(SomeCounters& counters, const Visit& visit) {
  visit("window_propagations", counters.window_propagations);
  visit("windows_created", counters.windows_created);
  visit("valid_windows", counters.valid_windows);
  visit("reinsertions", counters.reinsertions);
  visit("window_limit", counters.window_limit);
  visit("peak_wavefront", counters.peak_wavefront);
  visit("strip_depth", counters.strip_depth);
  visit("window_bytes", counters.window_bytes);
  visit("wavefront_sd", counters.wavefront_sd);
}

/// The counters of a recorded solve, and what else it records, by kind.
struct Recording : SolveCounters {
  RecordingKind kind = RecordingKind::counters;  ///< set by the caller
  /// For RecordingKind::wavefront: shares of the reachable vertices at which snapshots are taken,
  /// ascending.
  std::vector<double> snapshots_at = {};
  /// For RecordingKind::windows: called once at the end of the solve, by solvers that keep windows
  /// (Description::final_windows).
  const ReadWindows* read_windows = nullptr;
  /// For RecordingKind::paths: whether all windows that cross faces are kept (face_windows).
  bool keeps_windows = false;

  std::optional<PhaseTimes> phase_times;

  std::vector<WavefrontSample> curve = {};        ///< at equal steps of progress (progress.h)
  std::vector<WavefrontSnapshot> snapshots = {};  ///< those of snapshots_at that the solve reached
  /// For RecordingKind::wavefront: by vertex in internal numbers, the index of the first sample of
  /// the curve at which the vertex had a distance; kNone where it had none by the last.
  std::vector<Index> reached_by = {};

  /// For RecordingKind::paths: whether paths are shortest ones, as long as the distances of their
  /// ends. Other paths may bend at any vertex, and be shorter than these.
  bool shortest_paths = true;
  /// For RecordingKind::paths, in internal numbers: by vertex, and in the order of Query::targets.
  std::vector<LastSegment> last_segments = {};
  std::vector<AtTarget> targets = {};
  /// With `keeps_windows`, of solvers that propagate windows; otherwise null.
  std::shared_ptr<const FaceWindows> face_windows = nullptr;

  bool operator==(const Recording&) const = default;
};

}  // namespace geodesic
