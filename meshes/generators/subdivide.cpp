#include "meshes/generators/families.h"
#include "meshes/generators/input.h"
#include "meshes/generators/subdivision.h"

namespace geodesic {
namespace {

TriangleSoup make_subdivide(const CheckedParameters& parameters) {
  TriangleSoup soup = read_input(parameters);
  for (const std::string& step : parameters.words("steps")) {
    if (step == "midpoint") soup = subdivide_midpoint(soup);
    if (step == "loop") soup = subdivide_loop(soup);
    if (step == "barycentric") soup = subdivide_barycentric(soup);
  }
  return soup;
}

}  // namespace

Family subdivide() {
  return {
      {.name = "subdivide",
       .description = "a mesh with its faces cut: midpoint makes 4 faces of one and a vertex of "
                      "every edge, loop the same and smooths the surface, barycentric 6 "
                      "faces of one and a vertex of every edge and face",
       .closed_form = "",
       .parameters = {input_parameter(),
                      words_parameter("steps", {"midpoint", "loop", "barycentric"},
                                      "what to do, in this order")}},
      make_subdivide};
}

}  // namespace geodesic
