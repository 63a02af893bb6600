// The number of windows without a filter: Chen and Han 1990 bound it by the number of levels of
// their tree, at most one for each face, times that of corners.
#include <gtest/gtest.h>

#include "meshes/generators/generators.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

TEST(ChenHanWindows, RemainFewerThanTheSquareOfHalfEdgesWhereLinesWindRoundATubeThroughVertices) {
  const Index sides = 22;
  const Mesh mesh(generate("needles", {{"sides", int{sides}},
                                       {"rows", 8},
                                       {"aspect", 1e5},
                                       {"waist", 0.3},
                                       {"diagonal", "forward"}}));
  const std::uint64_t half_edges = mesh.half_edge_count();
  for (const Index source : {Index{0}, sides + 3, 2 * sides + 5}) {
    EXPECT_LT(propagated_by("ch", mesh, {.sources = {{source}}}), half_edges * half_edges / 4);
  }
}

}  // namespace
}  // namespace geodesic
