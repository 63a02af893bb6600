#include <algorithm>
#include <cmath>

#include "meshes/generators/known_distances.h"
#include "meshes/plane.h"

namespace geodesic {

std::vector<double> cylinder_distances(const CheckedParameters& parameters,
                                       const TriangleSoup& soup, Index source) {
  const Index sides = parameters.integer("sides");
  // Where the corners come to lie in the strip; the last entry is corner 0 again.
  std::vector<long double> along{0};
  for (Index i = 0; i < sides; ++i) {
    const Vec3 &a = soup.positions[i], &b = soup.positions[(i + 1) % sides];
    along.push_back(along.back() + distance({a[0], a[1]}, {b[0], b[1]}));
  }
  const auto unrolled = [&](Index v) -> PlanePoint {
    return {along[v % sides], soup.positions[v][2]};
  };
  const PlanePoint from = unrolled(source);
  std::vector<double> distances;
  distances.reserve(soup.positions.size());
  for (Index v = 0; v < soup.positions.size(); ++v) {
    const PlanePoint to = unrolled(v);
    const long double one_way = std::abs(to.x - from.x);
    const long double around = std::min(one_way, along.back() - one_way);
    distances.push_back(static_cast<double>(std::hypot(around, to.y - from.y)));
  }
  return distances;
}

}  // namespace geodesic
