#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/generators/known_distances.h"

namespace geodesic {
namespace {

struct Polar {
  Real radius = 0;
  Real angle = 0;  ///< about the apex, from the first leg
};

Real norm(const Vec3& p) { return std::hypot(Real{p[0]}, Real{p[1]}, Real{p[2]}); }

/// The angle at the origin between two points.
Real angle_between(const Vec3& a, const Vec3& b) {
  Real dot = 0, cross[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    dot += Real{a[k]} * b[k];
    cross[k] = Real{a[i]} * b[j] - Real{a[j]} * b[i];
  }
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), dot);
}

/// The unrolled fan: every vertex in polar coordinates about the apex, vertex 0 (sectors.h says how
/// the others are numbered). Neighbours on a ring lie in one plane with the apex: angles add up.
class UnrolledFan {
 public:
  UnrolledFan(const TriangleSoup& soup, Index sectors, Index rings) : polar_(1) {
    polar_.reserve(soup.positions.size());
    for (Index r = 1; r <= rings; ++r) {
      const auto first = static_cast<Index>(polar_.size());
      const Index count = sectors * r;
      Real angle = 0;
      for (Index i = 0; i < count; ++i) {
        const Vec3& here = soup.positions[first + i];
        polar_.push_back({norm(here), angle});
        angle += angle_between(here, soup.positions[first + (i + 1) % count]);
      }
      total_ = angle;
    }
  }

  Real distance(Index a, Index b) const {
    const Real one_way = std::abs(polar_[a].angle - polar_[b].angle);
    const Real angle = std::min(one_way, total_ - one_way);
    const Real r = polar_[a].radius, s = polar_[b].radius;
    if (angle >= std::numbers::pi_v<Real>) return r + s;
    // The law of cosines, in a form that loses no digits when the angle is small.
    return std::hypot(r - s, 2 * std::sqrt(r * s) * std::sin(angle / 2));
  }

 private:
  std::vector<Polar> polar_;
  Real total_ = 0;  // angle around the apex
};

}  // namespace

std::vector<double> fan_distances(const CheckedParameters& parameters, const TriangleSoup& soup,
                                  Index source) {
  const UnrolledFan fan(soup, parameters.integer("sectors"), parameters.integer("rings"));
  std::vector<double> distances;
  distances.reserve(soup.positions.size());
  for (Index v = 0; v < soup.positions.size(); ++v)
    distances.push_back(static_cast<double>(fan.distance(source, v)));
  return distances;
}

}  // namespace geodesic
