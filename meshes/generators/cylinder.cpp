#include <vector>

#include "meshes/generators/circle.h"
#include "meshes/generators/families.h"
#include "meshes/generators/known_distances.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

TriangleSoup make_cylinder(const CheckedParameters& parameters) {
  const Sheet sheet{.columns = parameters.integer("sides"),
                    .rows = parameters.integer("rows"),
                    .columns_wrap = true,
                    .diagonal = diagonal_of(parameters)};
  const double radius = parameters.real("radius");
  const double height = parameters.real("height");
  const std::vector<CirclePoint> circle = regular_polygon(sheet.columns);
  return make_sheet(sheet, [&](Index i, Index j) {
    return Vec3{radius * circle[i].cosine, radius * circle[i].sine, height * j / sheet.rows};
  });
}

}  // namespace

Family cylinder() {
  return {
      {.name = "cylinder",
       .description = "open tube over a regular polygon, axis z, sides (rows + 1) vertices; "
                      "vertex j * sides + i is corner i at height j / rows",
       .closed_form = "with w = 2 radius sin(pi / sides) and k corners from a to b the shorter "
                      "way round: d(a, b)^2 = (k w)^2 + (z_a - z_b)^2",
       .parameters = {integer_parameter("sides", 48, 3, 1000000, "corners of the polygon"),
                      integer_parameter("rows", 24, 1, 40000, "cells along the axis"),
                      real_parameter("radius", 1, 1e-6, 1e6, "of the corners"),
                      real_parameter("height", 3, 1e-6, 1e6, "of the tube"), diagonal_parameter()}},
      make_cylinder,
      cylinder_distances};
}

}  // namespace geodesic
