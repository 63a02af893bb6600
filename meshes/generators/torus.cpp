#include <vector>

#include "meshes/generators/circle.h"
#include "meshes/generators/families.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

TriangleSoup make_torus(const CheckedParameters& parameters) {
  const Sheet sheet{.columns = parameters.integer("rings"),
                    .rows = parameters.integer("sides"),
                    .columns_wrap = true,
                    .rows_wrap = true,
                    .diagonal = diagonal_of(parameters)};
  const double tube = parameters.real("tube-radius");
  const std::vector<CirclePoint> axis = regular_polygon(sheet.columns);
  const std::vector<CirclePoint> section = regular_polygon(sheet.rows);
  return make_sheet(sheet, [&](Index i, Index j) {
    const double radius = 1 + tube * section[j].cosine;
    return Vec3{radius * axis[i].cosine, radius * axis[i].sine, tube * section[j].sine};
  });
}

}  // namespace

Family torus() {
  return {{.name = "torus",
           .description = "tube around the unit circle of the plane z = 0, rings x sides vertices; "
                          "closed, genus 1",
           .closed_form = "",
           .parameters = {integer_parameter("rings", 64, 3, 100000, "cells around the hole"),
                          integer_parameter("sides", 32, 3, 100000, "cells around the tube"),
                          real_parameter("tube-radius", 0.4, 0.001, 0.99, "of the tube"),
                          diagonal_parameter()}},
          make_torus};
}

}  // namespace geodesic
