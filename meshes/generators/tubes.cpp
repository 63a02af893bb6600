// Generates tubes: cylinders and needles with open ends, closed tori and torus knots.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "meshes/generators/families.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

TriangleSoup make_cylinder(const CheckedParameters& parameters) {
  Sheet sheet = sheet_of(parameters, "sides", "rows");
  sheet.columns_wrap = true;
  const double radius = parameters.real("radius");
  const double height = parameters.real("height");
  const std::vector<CirclePoint> circle = regular_polygon(sheet.columns);
  return make_sheet(sheet, [&](Index i, Index j) {
    return Vec3{radius * circle[i].cosine, radius * circle[i].sine, height * j / sheet.rows};
  });
}

/// Distances on the strip that the tube unrolls to, by the shorter way around.
std::vector<double> cylinder_distances(const CheckedParameters& parameters,
                                       const TriangleSoup& soup, Index source) {
  const Index sides = parameters.integer("sides");
  // Positions of the corners in the strip; the last entry is corner 0 again.
  std::vector<Real> along{0};
  for (Index i = 0; i < sides; ++i) {
    const Vec3 &a = soup.positions[i], &b = soup.positions[(i + 1) % sides];
    along.push_back(along.back() + distance({a[0], a[1]}, {b[0], b[1]}));
  }
  const auto unrolled = [&](Index v) -> PlanePoint {
    return {along[v % sides], soup.positions[v][2]};
  };
  const PlanePoint from = unrolled(source);
  return distances_to_all(soup, [&](Index v) {
    const PlanePoint to = unrolled(v);
    const Real one_way = std::abs(to.x - from.x);
    const Real around = std::min(one_way, along.back() - one_way);
    return std::hypot(around, to.y - from.y);
  });
}

TriangleSoup make_needles(const CheckedParameters& parameters) {
  Sheet sheet = sheet_of(parameters, "sides", "rows");
  sheet.columns_wrap = true;
  const double narrow = 1 - parameters.real("waist");
  const std::vector<CirclePoint> circle = regular_polygon(sheet.columns);
  const double row_height = parameters.real("aspect") * kTwoPi / sheet.columns;
  return make_sheet(sheet, [&](Index i, Index j) {
    const double radius = j % 2 == 0 ? 1 : narrow;
    return Vec3{radius * circle[i].cosine, radius * circle[i].sine, row_height * j};
  });
}

TriangleSoup make_torus(const CheckedParameters& parameters) {
  Sheet sheet = sheet_of(parameters, "rings", "sides");
  sheet.columns_wrap = sheet.rows_wrap = true;
  const double tube = parameters.real("tube-radius");
  const std::vector<CirclePoint> axis = regular_polygon(sheet.columns);
  const std::vector<CirclePoint> section = regular_polygon(sheet.rows);
  return make_sheet(sheet, [&](Index i, Index j) {
    const double radius = 1 + tube * section[j].cosine;
    return Vec3{radius * axis[i].cosine, radius * axis[i].sine, tube * section[j].sine};
  });
}

// The (p, q) torus knot: p times around the axis of a torus, q times through its hole.

constexpr double kRingRadius = 2;  // of the torus that the knot lies on
constexpr double kWindRadius = 1;

/// A point of the knot with two unit vectors that span the plane across it.
struct Station {
  Vec3 centre;
  Vec3 normal;    // of the torus
  Vec3 binormal;  // normal x tangent
};

class Knot {
 public:
  Knot(Index p, Index q) : p_(p), q_(q) {}

  /// @param t in [0, 1], once around the knot
  Station at(double t) const {
    const CirclePoint round = circle_point(p_ * t), wind = circle_point(q_ * t);
    const double radius = kRingRadius + kWindRadius * wind.cosine;
    const Vec3 normal = {wind.cosine * round.cosine, wind.cosine * round.sine, wind.sine};
    // Velocity = p radius (-sin, cos, 0) + q winding direction, divided by 2 pi; both terms are
    // normal to `normal` and to one another.
    const double u = p_ * radius, w = q_ * kWindRadius;
    const double speed = std::sqrt(u * u + w * w);
    const Vec3 tangent = {(-u * round.sine - w * wind.sine * round.cosine) / speed,
                          (u * round.cosine - w * wind.sine * round.sine) / speed,
                          w * wind.cosine / speed};
    return {{radius * round.cosine, radius * round.sine, kWindRadius * wind.sine},
            normal,
            cross(normal, tangent)};
  }

  /// Returns `count` stations at equal arc lengths.
  std::vector<Station> stations(Index count) const {
    constexpr Index kSteps = 16;  // of the trapezoid rule per station
    const double steps = 1.0 * count * kSteps;
    std::vector<double> length = {0};
    for (Index k = 0; k < count * kSteps; ++k) {
      length.push_back(length.back() + (speed(k / steps) + speed((k + 1) / steps)) / 2);
    }
    std::vector<Station> result;
    std::size_t k = 0;
    for (Index i = 0; i < count; ++i) {
      const double wanted = length.back() * i / count;
      while (length[k + 1] <= wanted) ++k;
      const double part = (wanted - length[k]) / (length[k + 1] - length[k]);
      result.push_back(at((static_cast<double>(k) + part) / steps));
    }
    return result;
  }

 private:
  double speed(double t) const {
    const double u = p_ * (kRingRadius + kWindRadius * circle_point(q_ * t).cosine);
    const double w = q_ * kWindRadius;
    return std::sqrt(u * u + w * w);
  }

  double p_;
  double q_;
};

/// Returns the number of turns, rounded, that the torus's normal makes around the knot relative to
/// a frame without rotation. Turning back by it gives a periodic frame that hardly rotates.
double whole_twist(const std::vector<Station>& stations) {
  double twist = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& next = stations[(i + 1) % stations.size()];
    twist += dot(next.normal, stations[i].binormal);
  }
  return std::floor(twist / kTwoPi + 0.5);
}

TriangleSoup make_torus_knot(const CheckedParameters& parameters) {
  const Index p = parameters.integer("p"), q = parameters.integer("q");
  if (std::gcd(p, q) != 1) {
    throw std::invalid_argument("torus-knot: p and q must have no common divisor; " +
                                ParameterValue(p).text() + " and " + ParameterValue(q).text() +
                                " have");
  }
  Sheet sheet = sheet_of(parameters, "rings", "sides");
  sheet.columns_wrap = sheet.rows_wrap = true;
  const std::vector<Station> stations = Knot(p, q).stations(sheet.columns);
  const double twist = whole_twist(stations);
  const double radius = parameters.real("tube-radius");
  return make_sheet(sheet, [&](Index i, Index j) {
    const auto [cosine, sine] = circle_point(1.0 * j / sheet.rows - twist * i / sheet.columns);
    const Station& station = stations[i];
    return add(station.centre,
               scale(radius, add(scale(cosine, station.normal), scale(sine, station.binormal))));
  });
}

}  // namespace

std::vector<Family> tubes() {
  return {
      {{.name = "cylinder",
        .description = "open tube over a regular polygon, axis z, sides (rows + 1) vertices; "
                       "vertex j * sides + i is corner i at height j / rows",
        .closed_form = "with w = 2 radius sin(pi / sides) and k corners from a to b the shorter "
                       "way round: d(a, b)^2 = (k w)^2 + (z_a - z_b)^2",
        .parameters = {integer_parameter("sides", 48, 3, 1000000, "corners of the polygon"),
                       integer_parameter("rows", 24, 1, 40000, "cells along the axis"),
                       real_parameter("radius", 1, 1e-6, 1e6, "of the corners"),
                       real_parameter("height", 3, 1e-6, 1e6, "of the tube"),
                       diagonal_parameter()}},
       make_cylinder,
       cylinder_distances},
      {{.name = "needles",
        .description = "open tube of very thin triangles, rings of radius 1 and 1 - waist in "
                       "turn, sides (rows + 1) vertices; every vertex of an inner narrow ring is "
                       "a saddle",
        .parameters = {integer_parameter("sides", 240, 3, 1000000, "vertices of a ring"),
                       integer_parameter("rows", 8, 1, 40000, "bands of needles"),
                       real_parameter("aspect", 100, 1, 1e6, "length of a needle by its width"),
                       real_parameter("waist", 0.25, 0, 0.9, "depth of the narrow rings"),
                       diagonal_parameter()}},
       make_needles},
      {{.name = "torus",
        .description = "tube around the unit circle of the plane z = 0, rings x sides vertices; "
                       "closed, genus 1",
        .parameters = {integer_parameter("rings", 64, 3, 100000, "cells around the hole"),
                       integer_parameter("sides", 32, 3, 100000, "cells around the tube"),
                       real_parameter("tube-radius", 0.4, 0.001, 0.99, "of the tube"),
                       diagonal_parameter()}},
       make_torus},
      {{.name = "torus-knot",
        .description = "tube around the (p, q) torus knot on a torus of radii 2 and 1, rings at "
                       "equal distances, rings x sides vertices; closed, genus 1; the defaults "
                       "are a trefoil of 28,800 vertices and 57,600 faces",
        .parameters = {integer_parameter("p", 2, 1, 20, "times round the axis"),
                       integer_parameter("q", 3, 1, 20, "times through the hole"),
                       integer_parameter("rings", 576, 8, 100000, "cells along the tube"),
                       integer_parameter("sides", 50, 3, 10000, "cells around the tube"),
                       real_parameter("tube-radius", 0.36, 0.001, 0.9, "of the tube"),
                       diagonal_parameter()}},
       make_torus_knot}};
}

}  // namespace geodesic
