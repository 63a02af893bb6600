#include "solvers/core/last_segments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/core/window_predicates.h"

namespace geodesic {

LastSegments::LastSegments(const Mesh& mesh, const InternalQuery& query)
    : mesh_(mesh),
      query_(query),
      last_segments_(mesh.vertex_count()),
      targets_(query.targets.size()) {
  for (const InternalSource& source : query.sources) {
    if (source.at.is_vertex()) last_segments_[source.at.vertex].root = source.at.vertex;
  }
  for (Index i = 0; i < query.targets.size(); ++i) {
    const InternalPoint& target = query.targets[i];
    if (target.is_vertex()) continue;
    for (const InternalPoint& image : in_every_face(mesh, target)) places_.push_back({i, image});
  }
  if (places_.empty()) return;
  std::ranges::stable_sort(places_, {}, [](const Place& p) { return p.point.face; });
  first_target_.assign(mesh.face_count() + 1, 0);
  for (const Place& place : places_) ++first_target_[place.point.face + 1];
  for (Index f = 0; f < mesh.face_count(); ++f) first_target_[f + 1] += first_target_[f];
}

void LastSegments::cross(Index h, const Window& w, Index root, Index place) {
  const Point2 at = in_frame(mesh_, places_[place].point, h);
  if (!WindowSight(w, at).reaches()) return;
  offer(places_[place].target, least_distance_to(w, at.x, at.y), {h, root, {w.x, w.y}});
}

void LastSegments::offer(Index i, double distance, const LastSegment& last_segment) {
  if (distance < targets_[i].distance) targets_[i] = {distance, last_segment};
}

void LastSegments::finish(std::span<const double> distances, Recording& recording) {
  for (const Place& place : places_) finish_place(place, distances);
  for (Index i = 0; i < targets_.size(); ++i) {
    const InternalPoint& target = query_.targets[i];
    if (target.is_vertex()) targets_[i] = {distances[target.vertex], last_segments_[target.vertex]};
    if (targets_[i].distance > query_.limit) targets_[i] = {};
  }
  recording.last_segments = std::move(last_segments_);
  recording.targets = std::move(targets_);
}

void LastSegments::finish_place(const Place& place, std::span<const double> distances) {
  const Index face = place.point.face;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Point2 at = in_frame(mesh_, place.point, h);
    const Index corner = mesh_.origin(h);
    const double distance = distances[corner] + norm(at);
    // At a corner where no path bends, the line through it belongs to a window, which keeps a tie.
    const bool begins = mesh_.is_pseudo_source(corner) || last_segments_[corner].root == corner;
    if (!begins && distance > targets_[place.target].distance * (1 - kPathMargin)) continue;
    offer(place.target, distance, {h, corner, {0, 0}});
  }
  for (Index i = 0; i < query_.sources.size(); ++i) {
    const InternalSource& source = query_.sources[i];
    if (source.at.is_vertex()) continue;
    for (const InternalPoint& from : in_every_face(mesh_, source.at)) {
      if (from.face != face) continue;
      // In the frame at the nearest corner: near it, coordinates have all digits of the weights.
      const auto& weights = place.point.weights;
      const auto largest = std::ranges::max_element(weights) - weights.begin();
      const Index h = 3 * face + static_cast<Index>(largest);
      const Point2 start = in_frame(mesh_, from, h), end = in_frame(mesh_, place.point, h);
      offer(place.target, source.distance + norm(Point2{end.x - start.x, end.y - start.y}),
            {h, mesh_.vertex_count() + i, start});
    }
  }
}

}  // namespace geodesic
