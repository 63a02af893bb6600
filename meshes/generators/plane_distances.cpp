#include <algorithm>
#include <array>

#include "meshes/generators/known_distances.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

/// The open square (low, high) x (low, high) that no path may enter.
class Hole {
 public:
  Hole(long double low, long double high)
      : low_(low), high_(high), corners_{{{low, low}, {high, low}, {high, high}, {low, high}}} {}

  const std::array<PlanePoint, 4>& corners() const { return corners_; }

  /// Whether the segment enters the square: no axis of the square, and not the segment's own
  /// normal, separates the two. Exact for integer coordinates below 2^30.
  bool blocks(const PlanePoint& p, const PlanePoint& q) const {
    if (std::max(p.x, q.x) <= low_ || std::min(p.x, q.x) >= high_) return false;
    if (std::max(p.y, q.y) <= low_ || std::min(p.y, q.y) >= high_) return false;
    const auto side = [&](const PlanePoint& corner) { return turn(p, q, corner); };
    return std::any_of(corners_.begin(), corners_.end(), [&](auto& c) { return side(c) > 0; }) &&
           std::any_of(corners_.begin(), corners_.end(), [&](auto& c) { return side(c) < 0; });
  }

 private:
  long double low_, high_;
  std::array<PlanePoint, 4> corners_;  // neighbours in order
};

PlanePoint seen_from_above(const Vec3& p) { return {p[0], p[1]}; }

/// Distances of the hole's corners from `source`: straight, or onwards along the hole's sides.
std::array<long double, 4> corner_distances(const Hole& hole, const PlanePoint& source) {
  std::array<long double, 4> reached;
  for (std::size_t c = 0; c < 4; ++c) {
    const PlanePoint& corner = hole.corners()[c];
    reached[c] = hole.blocks(source, corner) ? kInfinity : distance(source, corner);
  }
  for (int round = 0; round < 3; ++round)
    for (std::size_t c = 0; c < 4; ++c)
      for (const std::size_t next : {(c + 1) % 4, (c + 3) % 4})
        reached[next] =
            std::min(reached[next], reached[c] + distance(hole.corners()[c], hole.corners()[next]));
  return reached;
}

}  // namespace

std::vector<double> plane_distances(const CheckedParameters& /*parameters*/,
                                    const TriangleSoup& soup, Index source) {
  const PlanePoint from = seen_from_above(soup.positions[source]);
  std::vector<double> distances;
  distances.reserve(soup.positions.size());
  for (const Vec3& p : soup.positions)
    distances.push_back(static_cast<double>(distance(from, seen_from_above(p))));
  return distances;
}

std::vector<double> square_with_hole_distances(const CheckedParameters& parameters,
                                               const TriangleSoup& soup, Index source) {
  const Index rim = parameters.integer("rim");
  const Hole hole(rim, rim + parameters.integer("hole"));
  const PlanePoint from = seen_from_above(soup.positions[source]);
  const std::array<long double, 4> corners = corner_distances(hole, from);
  std::vector<double> distances;
  distances.reserve(soup.positions.size());
  for (const Vec3& position : soup.positions) {
    const PlanePoint to = seen_from_above(position);
    long double least = hole.blocks(from, to) ? kInfinity : distance(from, to);
    for (std::size_t c = 0; c < 4; ++c)
      if (!hole.blocks(hole.corners()[c], to))
        least = std::min(least, corners[c] + distance(hole.corners()[c], to));
    distances.push_back(static_cast<double>(least));
  }
  return distances;
}

}  // namespace geodesic
