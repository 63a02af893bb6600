#include "meshes/generators/families.h"
#include "meshes/generators/known_distances.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

TriangleSoup make_grid(const CheckedParameters& parameters) {
  const Sheet sheet{.columns = parameters.integer("columns"),
                    .rows = parameters.integer("rows"),
                    .diagonal = diagonal_of(parameters)};
  const double spacing = parameters.real("spacing");
  return make_sheet(sheet, [&](Index i, Index j) { return Vec3{i * spacing, j * spacing, 0}; });
}

}  // namespace

Family grid() {
  return {{.name = "grid",
           .description = "flat rectangle in the plane z = 0, (columns + 1)(rows + 1) vertices",
           .closed_form = "d(a, b) = |a - b|",
           .parameters = {integer_parameter("columns", 32, 1, 40000, "cells along x"),
                          integer_parameter("rows", 32, 1, 40000, "cells along y"),
                          real_parameter("spacing", 1, 1e-6, 1e6, "side of a cell"),
                          diagonal_parameter()}},
          make_grid,
          plane_distances};
}

}  // namespace geodesic
