#include "solvers/core/last_segments.h"

#include <utility>

namespace geodesic {

LastSegments::LastSegments(const Mesh& mesh, const InternalQuery& query, bool keeps_windows)
    : query_(query),
      keeps_windows_(keeps_windows),
      last_segments_(mesh.vertex_count()),
      targets_(query.targets.size()),
      windows_(std::make_shared<FaceWindows>(mesh)) {
  for (const InternalSource& source : query.sources) {
    if (source.at.is_vertex()) last_segments_[source.at.vertex].root = source.at.vertex;
  }
  for (const InternalPoint& target : query.targets) {
    if (target.is_vertex()) continue;
    has_target_.resize(mesh.face_count());
    for (const InternalPoint& image : in_every_face(mesh, target)) has_target_[image.face] = true;
  }
}

void LastSegments::offer(Index i, double distance, const LastSegment& last_segment) {
  if (distance < targets_[i].distance) targets_[i] = {distance, last_segment};
}

void LastSegments::finish(std::span<const double> distances, Recording& recording) {
  if (keeps_windows_ || !has_target_.empty()) windows_->finish(query_, distances, last_segments_);
  for (Index i = 0; i < targets_.size(); ++i) {
    const InternalPoint& target = query_.targets[i];
    targets_[i] = target.is_vertex()
                      ? AtTarget{distances[target.vertex], last_segments_[target.vertex]}
                      : windows_->nearest(target, targets_[i]);
    if (targets_[i].distance > query_.limit) targets_[i] = {};
  }
  recording.last_segments = std::move(last_segments_);
  recording.targets = std::move(targets_);
  if (keeps_windows_) recording.face_windows = std::move(windows_);
}

}  // namespace geodesic
