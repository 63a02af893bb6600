#include "meshes/generators/natural_spline.h"

#include <utility>

namespace geodesic {
namespace {

/// Second derivatives m of the spline: m[i-1] + 4 m[i] + m[i+1] = 6 (y[i-1] - 2 y[i] + y[i+1]) at
/// the inner samples, 0 at both ends. Thomas's elimination; the matrix is diagonally dominant.
std::vector<double> second_derivatives(const std::vector<double>& y) {
  const std::size_t n = y.size();
  std::vector<double> m(n, 0), upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 4 - upper[i - 1];
    upper[i] = 1 / pivot;
    m[i] = (6 * ((y[i - 1] - y[i]) + (y[i + 1] - y[i])) - m[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
  return m;
}

}  // namespace

NaturalSpline::NaturalSpline(std::vector<double> samples)
    : samples_(std::move(samples)), curvature_(second_derivatives(samples_)) {}

double NaturalSpline::at(std::size_t interval, double part) const {
  const double rest = 1 - part;
  return rest * samples_[interval] + part * samples_[interval + 1] +
         (rest * (rest * rest - 1) * curvature_[interval] +
          part * (part * part - 1) * curvature_[interval + 1]) /
             6;
}

std::vector<double> NaturalSpline::resampled(std::size_t count) const {
  std::vector<double> values;
  values.reserve(count + 1);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t steps = k * (samples_.size() - 1);  // of 1 / count
    values.push_back(
        at(steps / count, static_cast<double>(steps % count) / static_cast<double>(count)));
  }
  values.push_back(samples_.back());
  return values;
}

}  // namespace geodesic
