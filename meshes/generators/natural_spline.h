// The natural cubic spline through samples at equal distances.
#pragma once

#include <cstddef>
#include <vector>

namespace geodesic {

/// The interpolating curve of least bending: twice continuously differentiable, without curvature
/// at its ends. Reproduces straight lines.
class NaturalSpline {
 public:
  /// @param samples values at 0, 1, 2, ...; at least two
  explicit NaturalSpline(std::vector<double> samples);

  /// The value at `interval` + `part`; that of the sample, exactly, where `part` is 0.
  /// @param interval below samples - 1
  /// @param part in [0, 1]
  double at(std::size_t interval, double part) const;

  /// The curve at `count` + 1 points at equal distances from the first sample to the last.
  std::vector<double> resampled(std::size_t count) const;

 private:
  std::vector<double> samples_;
  std::vector<double> curvature_;  // second derivative at each sample
};

}  // namespace geodesic
