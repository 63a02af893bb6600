#include <vector>

#include "meshes/generators/circle.h"
#include "meshes/generators/families.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

/// sin(2 pi bumps k / cells) for k = 0 ... cells.
std::vector<double> waves(double bumps, Index cells) {
  std::vector<double> sines(cells + 1);
  for (Index k = 0; k <= cells; ++k) sines[k] = circle_point(bumps * k / cells).sine;
  return sines;
}

TriangleSoup make_egg_carton(const CheckedParameters& parameters) {
  const Index cells = parameters.integer("cells");
  const double bumps = parameters.real("bumps");
  const double amplitude = parameters.real("height") / bumps;
  const std::vector<double> wave = waves(bumps, cells);
  const Sheet sheet{.columns = cells, .rows = cells, .diagonal = diagonal_of(parameters)};
  return make_sheet(sheet, [&](Index i, Index j) {
    return Vec3{1.0 * i / cells, 1.0 * j / cells, amplitude * wave[i] * wave[j]};
  });
}

}  // namespace

Family egg_carton() {
  return {{.name = "egg-carton",
           .description = "z = height / bumps sin(2 pi bumps x) sin(2 pi bumps y) over the unit "
                          "square, (cells + 1)^2 vertices; about half of them are saddles",
           .closed_form = "",
           .parameters = {integer_parameter("cells", 48, 2, 20000, "cells along x and along y"),
                          real_parameter("bumps", 4, 0.5, 10000, "periods along x and along y"),
                          real_parameter("height", 0.3, 0, 10, "of a bump by its period"),
                          diagonal_parameter("forward")}},
          make_egg_carton};
}

}  // namespace geodesic
