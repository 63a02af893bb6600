#include "meshes/generators/families.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

/// From the middle of the hole in its period of `pitch` cells to the middle of cell k, in cells.
double from_hole_centre(Index k, Index pitch) { return k % pitch + 0.5 - 0.5 * pitch; }

TriangleSoup make_holed_plate(const CheckedParameters& parameters) {
  const Index holes = parameters.integer("holes");
  const Index pitch = parameters.integer("pitch");
  const Index cells = holes * pitch;
  const double radius = parameters.real("hole-radius") * pitch;
  const double bulge = parameters.real("bulge");
  const Sheet sheet{.columns = cells, .rows = cells, .diagonal = diagonal_of(parameters)};
  const auto position = [&](Index i, Index j) {
    const double x = 1.0 * i / cells, y = 1.0 * j / cells;
    return Vec3{x, y, bulge * (16 * x * (1 - x) * y * (1 - y))};
  };
  const auto solid = [&](Index i, Index j) {
    const double x = from_hole_centre(i, pitch), y = from_hole_centre(j, pitch);
    return x * x + y * y > radius * radius;
  };
  TriangleSoup soup = make_sheet(sheet, position, solid);
  drop_isolated_vertices(soup);
  return soup;
}

}  // namespace

Family holed_plate() {
  return {{.name = "holed-plate",
           .description = "unit square with holes x holes round holes whose rims follow the cells, "
                          "so that every second rim vertex is a corner that paths bend at; flat or "
                          "bulging; one outer boundary loop and one a hole",
           .closed_form = "",
           .parameters = {integer_parameter("holes", 3, 1, 1000, "along x and along y"),
                          integer_parameter("pitch", 16, 4, 1000, "cells from hole to hole"),
                          real_parameter("hole-radius", 0.25, 0.15, 0.45, "by the pitch"),
                          real_parameter("bulge", 0, -10, 10, "height of the plate's middle"),
                          diagonal_parameter()}},
          make_holed_plate};
}

}  // namespace geodesic
