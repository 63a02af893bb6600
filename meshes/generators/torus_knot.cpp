// A tube around the (p, q) torus knot: p times round the axis of a torus, q times through its hole.
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "meshes/generators/circle.h"
#include "meshes/generators/families.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

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

  /// @param t in [0, 1], once round the knot
  Station at(double t) const {
    const CirclePoint round = circle_point(p_ * t), wind = circle_point(q_ * t);
    const double radius = kRingRadius + kWindRadius * wind.cosine;
    const Vec3 normal = {wind.cosine * round.cosine, wind.cosine * round.sine, wind.sine};
    // Velocity = p radius (-sin, cos, 0) + q winding direction, over 2 pi; both are normal to
    // `normal` and to one another.
    const double u = p_ * radius, w = q_ * kWindRadius;
    const double speed = std::sqrt(u * u + w * w);
    const Vec3 tangent = {(-u * round.sine - w * wind.sine * round.cosine) / speed,
                          (u * round.cosine - w * wind.sine * round.sine) / speed,
                          w * wind.cosine / speed};
    return {{radius * round.cosine, radius * round.sine, kWindRadius * wind.sine},
            normal,
            cross(normal, tangent)};
  }

  /// `count` stations at equal arc length.
  std::vector<Station> stations(Index count) const {
    constexpr Index kSteps = 16;  // of the trapezoid rule a station
    const double steps = 1.0 * count * kSteps;
    std::vector<double> length = {0};
    for (Index k = 0; k < count * kSteps; ++k)
      length.push_back(length.back() + (speed(k / steps) + speed((k + 1) / steps)) / 2);
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

/// Turns that the torus's normal makes around the knot against a frame that does not rotate,
/// rounded: turning back by it leaves a periodic frame that hardly rotates.
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
  if (std::gcd(p, q) != 1)
    throw std::invalid_argument("torus-knot: p and q must have no common divisor; " +
                                ParameterValue(p).text() + " and " + ParameterValue(q).text() +
                                " have");
  const Sheet sheet{.columns = parameters.integer("rings"),
                    .rows = parameters.integer("sides"),
                    .columns_wrap = true,
                    .rows_wrap = true,
                    .diagonal = diagonal_of(parameters)};
  const std::vector<Station> stations = Knot(p, q).stations(sheet.columns);
  const double twist = whole_twist(stations);
  const double radius = parameters.real("tube-radius");
  return make_sheet(sheet, [&](Index i, Index j) {
    const auto [cosine, sine] = circle_point(1.0 * j / sheet.rows - twist * i / sheet.columns);
    const Station& station = stations[i];
    Vec3 point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[axis] = station.centre[axis] +
                    radius * (cosine * station.normal[axis] + sine * station.binormal[axis]);
    return point;
  });
}

}  // namespace

Family torus_knot() {
  return {{.name = "torus-knot",
           .description = "tube around the (p, q) torus knot on a torus of radii 2 and 1, rings at "
                          "equal distances, rings x sides vertices; closed, genus 1; the defaults "
                          "are a trefoil of 28,800 vertices and 57,600 faces",
           .closed_form = "",
           .parameters = {integer_parameter("p", 2, 1, 20, "times round the axis"),
                          integer_parameter("q", 3, 1, 20, "times through the hole"),
                          integer_parameter("rings", 576, 8, 100000, "cells along the tube"),
                          integer_parameter("sides", 50, 3, 10000, "cells around the tube"),
                          real_parameter("tube-radius", 0.36, 0.001, 0.9, "of the tube"),
                          diagonal_parameter()}},
          make_torus_knot};
}

}  // namespace geodesic
