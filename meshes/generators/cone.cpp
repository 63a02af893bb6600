// The cone (total angle below 360 degrees) and the saddle (above) of planar sectors.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "meshes/generators/circle.h"
#include "meshes/generators/families.h"
#include "meshes/generators/known_distances.h"
#include "meshes/generators/sectors.h"

namespace geodesic {
namespace {

constexpr const char* kFanDistances =
    "unrolled, a vertex has polar coordinates r = |p| and theta, its angle in its sector plus that "
    "of the sectors before; with t the lesser angle from a to b round the apex: d(a, b) = "
    "sqrt(r_a^2 + r_b^2 - 2 r_a r_b cos t) when t < 180 degrees, else r_a + r_b";

/// Unit vectors at equal angles `sector_turns` from one to the next: around the z axis, all
/// equally far below the plane z = 0, or above and below it in turn.
std::vector<Vec3> ring_of_directions(Index count, double sector_turns, bool alternating) {
  // |u_i - u_i+1|: the chord of a sector's angle. Seen from above, neighbours are a chord of
  // 2 c sin(pi / count) apart, c their distance from the axis; alternating, also 2 sqrt(1 - c^2)
  // apart in height.
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
  if (sectors % 2 != 0 || sectors * angle <= 360)
    throw std::invalid_argument(
        "saddle-cone: sectors must be even and sectors x sector-angle "
        "above 360 degrees; " +
        ParameterValue(sectors).text() + " x " + ParameterValue(angle).text() + " is not");
  return sector_fan(ring_of_directions(sectors, angle / 360, true), parameters.integer("rings"));
}

}  // namespace

Family cone() {
  return {{.name = "cone",
           .description = "pyramid over a regular polygon, slant edges of length 1, apex vertex 0 "
                          "at the origin, 1 + sectors rings (rings + 1) / 2 vertices; open below",
           .closed_form = kFanDistances,
           .parameters = {integer_parameter("sectors", 12, 3, 100000, "sides of the pyramid"),
                          real_parameter("angle", 240, 1, 359, "total at the apex, degrees"),
                          integer_parameter("rings", 16, 1, 10000, "cells from apex to rim")}},
          make_cone,
          fan_distances};
}

Family saddle_cone() {
  return {
      {.name = "saddle-cone",
       .description = "planar sectors with edges of length 1 around vertex 0, rim corners up "
                      "and down in turn: total angle sectors x sector-angle, above 360 degrees; "
                      "1 + sectors rings (rings + 1) / 2 vertices",
       .closed_form = kFanDistances,
       .parameters = {integer_parameter("sectors", 8, 4, 1000, "an even number of planar parts"),
                      real_parameter("sector-angle", 60, 0.5, 120, "at the apex, degrees"),
                      integer_parameter("rings", 16, 1, 10000, "cells from apex to rim")}},
      make_saddle,
      fan_distances};
}

}  // namespace geodesic
