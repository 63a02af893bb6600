// What a recorded solve counts, times and samples, as plain data. Definitions: docs/metrics.md.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "solvers/core/phase_timer.h"
#include "solvers/core/window.h"

namespace geodesic {

/// The wavefront distances of the windows on the wavefront at one moment, in the mesh's unit.
struct WavefrontSample {
  Index reached = 0;          ///< vertices that have a finite distance by then
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
  double distance;    ///< its wavefront distance: the least over the interval

  bool operator==(const WavefrontWindow&) const = default;
};

/// All windows on the wavefront at the moment of a sample.
struct WavefrontSnapshot {
  double share;  ///< of the reachable vertices: taken with the first sample that had so many
  std::vector<WavefrontWindow> windows;  ///< in no particular order, as many as in the sample

  bool operator==(const WavefrontSnapshot&) const = default;
};

/// Gives the windows that determine the distance along an edge: in order, without overlap, parts
/// that nothing reached left out. Their frame is that of the edge's own half-edge, the smaller of
/// the twins. Lines go on into that half-edge's face where y < 0, into the twin's where y > 0, and
/// along the edge where y = 0. Valid as long as the call that hands it over.
/// @param half_edge either twin, in the mesh's numbering
/// @param windows overwritten
using FinalWindows = std::function<void(Index half_edge, std::vector<Window>& windows)>;

/// Does something with the final windows of a solve (Recording::read_windows).
using ReadWindows = std::function<void(const FinalWindows&)>;

/// How the shortest path to a vertex or a target arrives: the last of its straight pieces.
struct LastSegment {
  /// Its face holds the end of the piece: for a vertex, the apex of this half-edge. kNone at a
  /// source and where no path leads.
  Index half_edge = kNone;
  /// Where the piece begins: a vertex; or the number of vertices plus i for source i of the query,
  /// where that lies on an edge or in a face. The vertex itself at a source, kNone where no path
  /// leads.
  Index root = kNone;
  /// The root, unfolded along the piece into the frame of `half_edge`: y <= 0, but for a root in
  /// the same face.
  Point2 from = {0, 0};

  bool operator==(const LastSegment&) const = default;
};

/// A target of the query: its distance, exact wherever it lies, and how the path arrives.
struct AtTarget {
  double distance = kInfinity;
  LastSegment last_segment = {};

  bool operator==(const AtTarget&) const = default;
};

/// What a recorded solve is made for.
enum class RecordingKind : std::uint8_t {
  counters,
  phase_times,  ///< and nothing else
  wavefront,    ///< and counters
  windows,      ///< those that the solve ends with, and nothing else
  paths,        ///< how paths arrive, and nothing else
};

/// Integer results are the same on every run and every machine.
struct Recording {
  RecordingKind kind = RecordingKind::counters;  ///< set by the caller
  /// Of RecordingKind::wavefront: when to take snapshots, as shares of the reachable vertices,
  /// ascending.
  std::vector<double> snapshots_at = {};
  /// Of RecordingKind::windows: called once, when the solve is over, by solvers that keep them
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

  std::vector<WavefrontSample> curve = {};        ///< at equal steps of progress (progress.h)
  std::vector<WavefrontSnapshot> snapshots = {};  ///< those of snapshots_at that the solve got to
  /// Of RecordingKind::wavefront, by vertex in the mesh's internal numbers: the first sample of the
  /// curve by which it had a distance; kNone where it had none by the last.
  std::vector<Index> reached_by = {};

  /// Of RecordingKind::paths, both in the mesh's internal numbers: by vertex, and in the order of
  /// Query::targets.
  std::vector<LastSegment> last_segments = {};
  std::vector<AtTarget> targets = {};

  bool operator==(const Recording&) const = default;
};

}  // namespace geodesic
