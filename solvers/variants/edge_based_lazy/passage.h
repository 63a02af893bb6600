// How far a chunk of windows has been carried, and how far it can be.
//
// The windows of a chunk stay in the frame of the edge that they were unfolded onto last, their own
// frame. What moves is the edge that they have come to: crossing a face turns and shifts that edge
// as seen in their frame, a rigid motion composed of those of the faces. Each composition rounds as
// unfolding a source across the face does, so that k faces crossed at once are as exact as k faces
// crossed one by one; as there, the motion is not renormalised.
//
// All lines of the chunk lie between two bounds, from the outermost ends of its windows in the
// directions that lean out most. A face whose apex lies clearly outside them is crossed unseen.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solvers/core/window.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based_lazy {

using edge_based::Side;

/// A chunk is made explicit after this many faces, so that what is beaten gets dropped.
inline constexpr std::uint32_t kMostFaces = 32;

/// An apex is outside the bounds when it is farther from them than this, relative to the
/// coordinates compared: far more than rounding, or kApexTolerance.
inline constexpr double kClear = 1e-9;

/// The direction of a line is certain when its source is deeper below the edge than this, relative
/// to the coordinates whose difference it is; where a line meets an edge, when the sine of the
/// angle between them is larger.
inline constexpr double kShallow = 1e-4;

class Passage {
 public:
  /// Of windows that lie on their own edge.
  template <class Segment>
  explicit Passage(const Segment& chunk);

  /// Faces that the chunk was carried across.
  std::uint32_t faces() const { return faces_; }

  /// Crosses a face when all lines certainly pass its apex on one side.
  /// @param side left or right
  /// @return false when they do not, or may not; nothing has changed then
  bool carry(const FaceFrame& face, Side side);

  /// Moves the windows to the edge that they have come to.
  template <class Segment>
  void arrive(Segment& chunk) const;

 private:
  void arrive(std::size_t count, double* begin, double* end, double* x, double* y) const;

  /// A point or vector given in the frame of the edge that the chunk has come to, in the chunk's.
  Point2 along(double x, double y) const { return {x * ux_ - y * uy_, x * uy_ + y * ux_}; }
  /// The reverse for a vector.
  Point2 across(double dx, double dy) const { return {dx * ux_ + dy * uy_, dy * ux_ - dx * uy_}; }

  double left_ = kInfinity, left_slope_ = kInfinity;  // where x = left_ + left_slope_ * y
  double right_ = -kInfinity, right_slope_ = -kInfinity;
  double x_ = 0, y_ = 0;    // origin of the edge that the chunk has come to
  double ux_ = 1, uy_ = 0;  // unit vector along it
  double length_ = 0;       // its length, once it is another than the chunk's own
  std::uint32_t faces_ = 0;
};

template <class Segment>
Passage::Passage(const Segment& chunk) {
  const double* begin = chunk.array(edge_based::kBegin);
  const double* end = chunk.array(edge_based::kEnd);
  const double* x = chunk.array(edge_based::kX);
  const double* y = chunk.array(edge_based::kY);
  bool certain = true;
  for (std::size_t i = 0; i < chunk.count; ++i) {
    const double depth = -y[i];
    certain &= depth > kShallow * (std::abs(x[i]) + end[i]);
    left_ = std::min(left_, begin[i]);
    right_ = std::max(right_, end[i]);
    left_slope_ = std::min(left_slope_, (begin[i] - x[i]) / depth);
    right_slope_ = std::max(right_slope_, (end[i] - x[i]) / depth);
  }
  if (certain) return;
  left_slope_ = -kInfinity;  // outside these bounds is nothing
  right_slope_ = kInfinity;
}

template <class Segment>
void Passage::arrive(Segment& chunk) const {
  arrive(chunk.count, chunk.array(edge_based::kBegin), chunk.array(edge_based::kEnd),
         chunk.array(edge_based::kX), chunk.array(edge_based::kY));
}

}  // namespace geodesic::edge_based_lazy
