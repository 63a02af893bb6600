// The last segments of shortest paths to vertices and targets, collected during a solve.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/face_windows.h"
#include "solvers/core/query.h"
#include "solvers/core/recording.h"

namespace geodesic {

/// Collects the last segments in one solve of one query.
class LastSegments {
 public:
  /// @param keeps_windows as Recording::keeps_windows; otherwise only those of targets' faces stay
  LastSegments(const Mesh& mesh, const InternalQuery& query, bool keeps_windows = false);

  /// These functions implement those of PathRecorder (recorders.h).
  void arrived(Index v, const LastSegment& last_segment) { last_segments_[v] = last_segment; }
  const LastSegment& last_segment(Index v) const { return last_segments_[v]; }
  void crosses(Index h, const Window& w, Index root) {
    crosses(h, [&](const auto& add) { add(w, root); });
  }
  /// As above, for several windows.
  /// @param for_each_window as in FaceWindows::add
  template <class ForEachWindow>
  void crosses(Index h, const ForEachWindow& for_each_window) {
    if (wants(h)) windows_->add(h, for_each_window);
  }

  /// Notes a straight line to target i of the query, if none as short is known.
  /// @param distance of the target by this line
  void offer(Index i, double distance, const LastSegment& last_segment);

  /// Finds the last segments of the targets. Moves everything into the recording.
  /// @param distances of the solve
  void finish(std::span<const double> distances, Recording& recording);

 private:
  bool wants(Index h) const {
    return keeps_windows_ || (!has_target_.empty() && has_target_[h / 3]);
  }

  const InternalQuery& query_;
  bool keeps_windows_;
  std::vector<LastSegment> last_segments_;
  std::vector<AtTarget> targets_;
  std::vector<bool> has_target_;  // by face; empty if all targets are vertices
  std::shared_ptr<FaceWindows> windows_;
};

}  // namespace geodesic
