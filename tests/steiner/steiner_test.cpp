// More Steiner points shorten paths; without any, the paths are those of Dijkstra. The conformance
// properties check that no path is too short, and all other promises of solvers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "meshes/oracles/random_meshes.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

std::vector<double> distances(const std::string& solver, const Mesh& mesh, Index source) {
  return distances_by(solver, mesh, {.sources = {{source}}});
}

std::string with_points(Index points) { return "steiner?points=" + std::to_string(points); }

TEST(Steiner, gives_the_bits_of_dijkstra_without_points) {
  const Mesh mesh(rough_terrain(3, 12, 12, 1));
  EXPECT_EQ(distances(with_points(0), mesh, 7), distances("dijkstra", mesh, 7));
}

TEST(Steiner, gives_no_longer_distances_with_points_between_those_there_are) {
  const Mesh mesh(rough_sphere(5, 2, 0.2));
  std::vector<double> before = distances(with_points(0), mesh, 7);
  for (const Index points : {1u, 3u, 7u, 15u}) {
    const std::vector<double> after = distances(with_points(points), mesh, 7);
    double sum_before = 0, sum_after = 0;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_LE(after[v], before[v] * (1 + 1e-12)) << points << " points, vertex " << v;
      sum_before += before[v];
      sum_after += after[v];
    }
    EXPECT_LT(sum_after, sum_before) << points << " points";
    before = after;
  }
}

// The unit square of two triangles, whose common edge leads from (1, 0) to (0, 1).
TEST(Steiner, crosses_an_edge_at_its_points) {
  const Mesh mesh(
      TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}});
  EXPECT_EQ(distances(with_points(0), mesh, 0)[2], 2);
  EXPECT_NEAR(distances(with_points(1), mesh, 0)[2], std::sqrt(2), 1e-15);
  // The points lie at a third and at two thirds.
  EXPECT_NEAR(distances(with_points(2), mesh, 0)[2], 2 * std::sqrt(5) / 3, 1e-15);
}

TEST(Steiner, is_refused_with_more_points_than_it_has_a_use_for) {
  const Mesh mesh(rough_terrain(3, 3, 3, 1));
  EXPECT_THROW(make_solver(with_points(101), mesh), std::invalid_argument);
}

}  // namespace
}  // namespace geodesic
