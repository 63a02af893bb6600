// Compiled for every processor, and apart from the loop that is compiled for AVX2 too: there GCC 12
// fuses the multiplications of a sum and a difference side by side (vfmaddsub), whatever
// -ffp-contract says, and distances would depend on where it does.
#include "solvers/variants/edge_based_lazy/passage.h"

namespace geodesic::edge_based_lazy {

bool Passage::carry(const FaceFrame& face, Side side) {
  if (faces_ == kMostFaces) return false;
  Point2 apex = along(face.apex_x, face.apex_y);
  apex.x += x_;
  apex.y += y_;
  if (!(apex.y > 0)) return false;
  const double left = left_ + left_slope_ * apex.y, right = right_ + right_slope_ * apex.y;
  const double margin = kClear * (std::abs(apex.x) + std::abs(left) + std::abs(right) + apex.y);
  const bool to_left = side == Side::left;
  if (!(to_left ? apex.x - right > margin : left - apex.x > margin)) return false;
  const Point2 u = to_left ? along(face.left_x, face.left_y) : along(face.right_x, face.right_y);
  const auto rises = [&](double slope) {
    return u.x - slope * u.y > kShallow * (1 + std::abs(slope));
  };
  if (!rises(left_slope_) || !rises(right_slope_)) return false;
  ux_ = u.x;
  uy_ = u.y;
  if (!to_left) {
    x_ = apex.x;
    y_ = apex.y;
  }
  length_ = to_left ? face.left : face.right;
  ++faces_;
  return true;
}

void Passage::arrive(std::size_t count, double* begin, double* end, double* x, double* y) const {
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 source = across(x[i] - x_, y[i] - y_);
    const auto meet = [&](double t) {
      const Point2 p = across(t - x_, -y_);
      const double position = source.x + (p.x - source.x) * (source.y / (source.y - p.y));
      return std::min(std::max(position, 0.0), length_);
    };
    begin[i] = meet(begin[i]);
    end[i] = std::max(begin[i], meet(end[i]));
    x[i] = source.x;
    y[i] = std::min(source.y, 0.0);
  }
}

}  // namespace geodesic::edge_based_lazy
