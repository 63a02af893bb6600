#include "meshes/generators/families.h"
#include "meshes/generators/known_distances.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

TriangleSoup make_square_with_hole(const CheckedParameters& parameters) {
  const Index hole = parameters.integer("hole");
  const Index rim = parameters.integer("rim");
  const Index end = rim + hole;
  const Sheet sheet{.columns = end + rim, .rows = end + rim, .diagonal = diagonal_of(parameters)};
  const auto position = [](Index i, Index j) { return Vec3{1.0 * i, 1.0 * j, 0}; };
  const auto solid = [&](Index i, Index j) { return i < rim || i >= end || j < rim || j >= end; };
  TriangleSoup soup = make_sheet(sheet, position, solid);
  drop_isolated_vertices(soup);
  return soup;
}

}  // namespace

Family square_with_hole() {
  return {{.name = "square-with-hole",
           .description = "flat square of unit cells in the plane z = 0 with a square hole in its "
                          "middle, hole corners at rim and rim + hole",
           .closed_form = "the least length of a polyline from a to b through none, one or two "
                          "neighbouring corners of the hole that does not enter its interior",
           .parameters = {integer_parameter("hole", 10, 1, 20000, "side of the hole in cells"),
                          integer_parameter("rim", 10, 1, 10000, "cells from hole to border"),
                          diagonal_parameter()}},
          make_square_with_hole,
          square_with_hole_distances};
}

}  // namespace geodesic
