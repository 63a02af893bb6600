#include "meshes/generators/circle.h"

#include <cmath>

namespace geodesic {
namespace {

/// 1 - x^2 / (k (k+1)) * (1 - x^2 / ((k+2) (k+3)) * (...)): the Taylor series of the cosine for
/// k = 1, of sin(x) / x for k = 2. Twenty factors reach 1e-20 for |x| <= pi / 4.
double nested_series(double x, int k) {
  double sum = 1;
  for (int i = k + 18; i >= k; i -= 2) sum = 1 - sum * (x * x) / (i * (i + 1));
  return sum;
}

}  // namespace

CirclePoint circle_point(double turns) {
  const double fraction = turns - std::floor(turns);
  const double quarter = std::floor(4 * fraction + 0.5);
  // Exact (Sterbenz); the rest lies within an eighth of a turn of a coordinate axis.
  const double x = (fraction - quarter / 4) * kTwoPi;
  const double cosine = nested_series(x, 1);
  const double sine = x * nested_series(x, 2);
  switch (static_cast<int>(quarter) % 4) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

std::vector<CirclePoint> regular_polygon(Index n) {
  std::vector<CirclePoint> corners(n);
  for (Index i = 0; i < n; ++i) corners[i] = circle_point(static_cast<double>(i) / n);
  return corners;
}

}  // namespace geodesic
