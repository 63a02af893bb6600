// The points of a path or line while it is traced.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "solvers/core/path.h"
#include "solvers/core/tolerance.h"

namespace geodesic {

/// The points from one end to the other; `travelled` is the length from the previous one.
class PathPoints {
 public:
  explicit PathPoints(const Mesh& mesh) : mesh_(mesh) {}

  /// Adds the next point, unless it equals the last point.
  /// @param face shared with the previous point
  void add(const InternalPoint& image, Index face, double step) {
    const InternalPoint own = in_given_face(mesh_, image);
    if (!points_.empty() && own == last_) return;
    last_ = own;
    PathPoint point;
    point.at = in_external_numbers(mesh_, own);
    point.position = position_of(mesh_, own);
    point.travelled = step;
    if (face != kNone) point.face = mesh_.numbers().external_face(face % mesh_.given_face_count());
    points_.push_back(point);
  }

  /// Adds the point where a line leaves a face.
  /// @param x distance from the head of h, by which the line leaves
  void add_edge_point(Index h, double x, double step) {
    const double length = mesh_.half_edge(h).length;
    const double at_origin = length > 0 ? x / length : 0, at_head = 1 - at_origin;
    InternalPoint point;
    if (std::min(at_origin, at_head) <= kWeightSum) {  // equal to a vertex up to rounding
      point.vertex = at_head > at_origin ? mesh_.head(h) : mesh_.origin(h);
    } else {
      point.face = h / 3;
      point.weights[h % 3] = at_origin;
      point.weights[Mesh::next(h) % 3] = at_head;
    }
    add(point, h / 3, step);
  }

  /// A length of the list, to which `shorten` returns.
  struct Mark {
    std::size_t size;
    InternalPoint last;
  };
  Mark mark() const { return {points_.size(), last_}; }
  void shorten(const Mark& mark) {
    points_.resize(mark.size);
    last_ = mark.last;
  }

  /// Returns the points of a line that was traced from its begin.
  std::vector<PathPoint> from_begin() {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      points_[i - 1].face = std::exchange(points_[i].face, kNone);
      points_[i].travelled += points_[i - 1].travelled;
    }
    return std::move(points_);
  }

  /// Returns the path that was traced from its end, from its source.
  Path from_source(Index source) {
    std::ranges::reverse(points_);
    double travelled = 0;
    for (PathPoint& point : points_) {
      travelled += std::exchange(point.travelled, travelled);
    }
    return {source, std::move(points_)};
  }

 private:
  const Mesh& mesh_;
  std::vector<PathPoint> points_;
  InternalPoint last_;
};

}  // namespace geodesic
