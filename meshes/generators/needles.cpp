#include <vector>

#include "meshes/generators/circle.h"
#include "meshes/generators/families.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

TriangleSoup make_needles(const CheckedParameters& parameters) {
  const Sheet sheet{.columns = parameters.integer("sides"),
                    .rows = parameters.integer("rows"),
                    .columns_wrap = true,
                    .diagonal = diagonal_of(parameters)};
  const double narrow = 1 - parameters.real("waist");
  const std::vector<CirclePoint> circle = regular_polygon(sheet.columns);
  const double row_height = parameters.real("aspect") * kTwoPi / sheet.columns;
  return make_sheet(sheet, [&](Index i, Index j) {
    const double radius = j % 2 == 0 ? 1 : narrow;
    return Vec3{radius * circle[i].cosine, radius * circle[i].sine, row_height * j};
  });
}

}  // namespace

Family needles() {
  return {
      {.name = "needles",
       .description = "open tube of very thin triangles, rings of radius 1 and 1 - waist in "
                      "turn, sides (rows + 1) vertices; every vertex of an inner narrow ring is "
                      "a saddle",
       .closed_form = "",
       .parameters = {integer_parameter("sides", 240, 3, 1000000, "vertices of a ring"),
                      integer_parameter("rows", 8, 1, 40000, "bands of needles"),
                      real_parameter("aspect", 100, 1, 1e6, "length of a needle by its width"),
                      real_parameter("waist", 0.25, 0, 0.9, "depth of the narrow rings"),
                      diagonal_parameter()}},
      make_needles};
}

}  // namespace geodesic
