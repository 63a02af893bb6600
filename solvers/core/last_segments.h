// The last segments of shortest paths to vertices and targets, collected during a solve.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/query.h"
#include "solvers/core/recording.h"

namespace geodesic {

/// Collects the last segments in one solve of one query.
class LastSegments {
 public:
  LastSegments(const Mesh& mesh, const InternalQuery& query);

  /// These functions implement those of PathRecorder (recorders.h).
  void arrived(Index v, const LastSegment& last_segment) { last_segments_[v] = last_segment; }
  const LastSegment& last_segment(Index v) const { return last_segments_[v]; }
  void crosses(Index h, const Window& w, Index root) {
    if (first_target_.empty()) return;
    const Index face = h / 3;
    for (Index i = first_target_[face]; i < first_target_[face + 1]; ++i) cross(h, w, root, i);
  }

  /// Notes a straight line to target i of the query, if none as short is known.
  /// @param distance of the target by this line
  void offer(Index i, double distance, const LastSegment& last_segment);

  /// Adds the segments that need no windows: straight lines to targets from the corners of their
  /// faces and from sources in the same face. Moves everything into the recording.
  /// @param distances of the solve
  void finish(std::span<const double> distances, Recording& recording);

 private:
  /// A target that is not a vertex, once for each face that contains it.
  struct Place {
    Index target;
    InternalPoint point;
  };

  void add_place(Index target, const InternalPoint& point);
  void cross(Index h, const Window& w, Index root, Index place);
  void finish_place(const Place& place, std::span<const double> distances);

  const Mesh& mesh_;
  const InternalQuery& query_;
  std::vector<LastSegment> last_segments_;
  std::vector<AtTarget> targets_;
  std::vector<Place> places_;        // by face
  std::vector<Index> first_target_;  // offsets into places_, by face; empty without places
};

}  // namespace geodesic
