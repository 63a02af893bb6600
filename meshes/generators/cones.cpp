// Generates the cone (total angle below 360 degrees) and the saddle (above) of planar sectors
// around vertex 0. Their distances are those of an unrolled fan.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "meshes/generators/families.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

/// Id of the first vertex of ring r >= 1.
Index first_of_ring(Index sectors, Index r) { return 1 + sectors * (r * (r - 1) / 2); }

/// Id of vertex k of sector i in ring r; k = r is the first vertex of the next sector.
Index fan_vertex(Index sectors, Index r, Index i, Index k) {
  return r == 0 ? 0 : first_of_ring(sectors, r) + (i * r + k) % (sectors * r);
}

/// Returns a closed fan. Sector i, cut into `rings`^2 similar triangles, is the planar triangle of
/// the origin and directions i and i + 1 (of the last sector, the last and the first).
///
/// Vertex 0 is the origin. Rings r = 1 ... rings follow with r vertices per sector: vertex i r + k
/// of a ring lies k / r of the way from r / rings * directions[i] to r / rings * directions[i + 1].
TriangleSoup sector_fan(const std::vector<Vec3>& directions, Index rings) {
  const auto sectors = static_cast<Index>(directions.size());
  check_face_count(1.0 * sectors * rings * rings);
  TriangleSoup soup;
  soup.positions.push_back({0, 0, 0});
  for (Index r = 1; r <= rings; ++r) {
    for (Index i = 0; i < sectors; ++i) {
      for (Index k = 0; k < r; ++k) {
        Vec3 point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          point[axis] =
              ((r - k) * directions[i][axis] + k * directions[(i + 1) % sectors][axis]) / rings;
        }
        soup.positions.push_back(point);
      }
    }
  }
  for (Index r = 1; r <= rings; ++r) {
    for (Index i = 0; i < sectors; ++i) {
      for (Index k = 0; k < r; ++k) {
        const Index inner = fan_vertex(sectors, r - 1, i, k);
        const Index outer = fan_vertex(sectors, r, i, k + 1);
        soup.triangles.push_back({inner, fan_vertex(sectors, r, i, k), outer});
        if (k + 1 < r) {
          soup.triangles.push_back({inner, outer, fan_vertex(sectors, r - 1, i, k + 1)});
        }
      }
    }
  }
  return soup;
}

/// Returns unit vectors around the z axis at equal angles `sector_turns` from one to the next. All
/// are equally far below the plane z = 0, or alternately below and above it.
std::vector<Vec3> ring_of_directions(Index count, double sector_turns, bool alternating) {
  // |u_i - u_i+1| is the chord of a sector's angle. Let c be the distance of the ends from the
  // axis. Seen from above, neighbours are 2 c sin(pi / count) apart; alternating ones are also 2
  // sqrt(1 - c^2) apart in height.
  const double half_chord = circle_point(sector_turns / 2).sine;
  const double half_step = circle_point(0.5 / count).sine;
  const double c2 = alternating ? (1 - half_chord * half_chord) / (1 - half_step * half_step)
                                : half_chord * half_chord / (half_step * half_step);
  const double c = std::sqrt(c2), height = std::sqrt(std::max(0.0, 1 - c2));
  std::vector<Vec3> directions;
  for (const auto& [cosine, sine] : regular_polygon(count)) {
    const bool up = alternating && directions.size() % 2 == 0;
    directions.push_back({c * cosine, c * sine, up ? height : -height});
  }
  return directions;
}

TriangleSoup make_cone(const CheckedParameters& parameters) {
  const Index sectors = parameters.integer("sectors");
  const double turns = parameters.real("angle") / 360 / sectors;
  return sector_fan(ring_of_directions(sectors, turns, false), parameters.integer("rings"));
}

TriangleSoup make_saddle(const CheckedParameters& parameters) {
  const Index sectors = parameters.integer("sectors");
  const double angle = parameters.real("sector-angle");
  if (sectors % 2 != 0 || sectors * angle <= 360) {
    throw std::invalid_argument(
        "saddle-cone: sectors must be even and sectors x sector-angle "
        "above 360 degrees; " +
        ParameterValue(sectors).text() + " x " + ParameterValue(angle).text() + " is not");
  }
  return sector_fan(ring_of_directions(sectors, angle / 360, true), parameters.integer("rings"));
}

struct Polar {
  Real radius = 0;
  Real angle = 0;  ///< about the apex, from the first leg
};

/// Returns the angle at the origin between two points.
Real angle_between(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  const auto [x, y, z] = cross(a, b);
  return std::atan2(std::hypot(x, y, z), dot(a, b));
}

/// The unrolled fan: every vertex in polar coordinates about the apex, vertex 0. Neighbours on a
/// ring lie in one plane with the apex, so that angles add up.
class UnrolledFan {
 public:
  UnrolledFan(const TriangleSoup& soup, Index sectors, Index rings) : polar_(1) {
    polar_.reserve(soup.positions.size());
    for (Index r = 1; r <= rings; ++r) {
      const auto first = static_cast<Index>(polar_.size());
      const Index count = sectors * r;
      Real angle = 0;
      for (Index i = 0; i < count; ++i) {
        const auto here = extended(soup.positions[first + i]);
        polar_.push_back({std::hypot(here[0], here[1], here[2]), angle});
        angle += angle_between(here, extended(soup.positions[first + (i + 1) % count]));
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

/// Distances on the unrolled sectors around vertex 0: a straight line if the lesser angle at the
/// apex is below 180 degrees, else the way through the apex. The corners of the rim are convex: the
/// straight line never leaves the mesh.
std::vector<double> fan_distances(const CheckedParameters& parameters, const TriangleSoup& soup,
                                  Index source) {
  const UnrolledFan fan(soup, parameters.integer("sectors"), parameters.integer("rings"));
  return distances_to_all(soup, [&](Index v) { return fan.distance(source, v); });
}

constexpr const char* kFanDistances =
    "unrolled, a vertex has polar coordinates r = |p| and theta, its angle in its sector plus that "
    "of the sectors before; with t the lesser angle from a to b round the apex: d(a, b) = "
    "sqrt(r_a^2 + r_b^2 - 2 r_a r_b cos t) when t < 180 degrees, else r_a + r_b";

}  // namespace

std::vector<Family> cones() {
  return {
      {{.name = "cone",
        .description = "pyramid over a regular polygon, slant edges of length 1, apex vertex 0 "
                       "at the origin, 1 + sectors rings (rings + 1) / 2 vertices; open below",
        .closed_form = kFanDistances,
        .parameters = {integer_parameter("sectors", 12, 3, 100000, "sides of the pyramid"),
                       real_parameter("angle", 240, 1, 359, "total at the apex, degrees"),
                       integer_parameter("rings", 16, 1, 10000, "cells from apex to rim")}},
       make_cone,
       fan_distances},
      {{.name = "saddle-cone",
        .description = "planar sectors with edges of length 1 around vertex 0, rim corners up "
                       "and down in turn: total angle sectors x sector-angle, above 360 degrees; "
                       "1 + sectors rings (rings + 1) / 2 vertices",
        .closed_form = kFanDistances,
        .parameters = {integer_parameter("sectors", 8, 4, 1000, "an even number of planar parts"),
                       real_parameter("sector-angle", 60, 0.5, 120, "at the apex, degrees"),
                       integer_parameter("rings", 16, 1, 10000, "cells from apex to rim")}},
       make_saddle,
       fan_distances}};
}

}  // namespace geodesic
