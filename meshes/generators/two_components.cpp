#include "meshes/generators/families.h"
#include "meshes/generators/generators.h"

namespace geodesic {
namespace {

/// Adds `part` moved along x, its ids after those that are there.
void append(TriangleSoup& soup, const TriangleSoup& part, double x_shift) {
  const auto first = static_cast<Index>(soup.positions.size());
  for (const auto& [x, y, z] : part.positions) soup.positions.push_back({x + x_shift, y, z});
  for (const auto& [a, b, c] : part.triangles)
    soup.triangles.push_back({first + a, first + b, first + c});
}

TriangleSoup make_two_components(const CheckedParameters& parameters) {
  TriangleSoup soup = generate("icosphere", {{"frequency", parameters.integer("frequency")}});
  soup.positions.push_back({2, 2, 2});
  const Index cells = parameters.integer("cells");
  append(
      soup,
      generate(
          "box",
          {{"x-cells", cells}, {"y-cells", cells}, {"z-cells", cells}, {"spacing", 1.0 / cells}}),
      3);
  return soup;
}

}  // namespace

Family two_components() {
  return {{.name = "two-components",
           .description = "a unit icosphere, then one isolated vertex, then a cube of side 1: each "
                          "unreachable from the others",
           .closed_form = "",
           .parameters = {integer_parameter("frequency", 10, 1, 4000, "of the icosphere"),
                          integer_parameter("cells", 8, 1, 4000, "along a side of the cube")}},
          make_two_components};
}

}  // namespace geodesic
