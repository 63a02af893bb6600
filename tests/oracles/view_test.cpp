// Brute force: the numbering of its results, and its precision on needles.
#include <gtest/gtest.h>

#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/random_meshes.h"

namespace geodesic {
namespace {

TEST(BruteForce, answers_by_the_numbers_given_however_a_mesh_numbers_itself) {
  const TriangleSoup soup = rough_sphere(6, 2, 0.2);
  const Mesh renumbered(soup, Numbering::along_surface);
  ASSERT_FALSE(renumbered.numbers().is_identity());
  const std::vector<Source> sources{{.at = 5}, {.at = 17, .distance = 0.25}};
  const std::vector<double> expected = BruteForce(Mesh(soup)).distances(sources);
  const std::vector<double> got = BruteForce(renumbered).distances(sources);
  for (Index v = 0; v < expected.size(); ++v) EXPECT_NEAR(got[v], expected[v], 1e-15) << v;
}

// Two needles in one plane share their short side. The straight line from tip to tip crosses the
// middle of that side.
TEST(BruteForce, is_straight_across_the_short_side_of_needles) {
  const auto opposite = [](const Vec3& p) { return Vec3{-p[0], -p[1], -p[2]}; };
  const Vec3 tip = {0.7, -0.9, 0.4};
  for (double width = 1e-3; width > 1e-15; width /= 7) {
    const Vec3 side = {0.8 * width, 0.1 * width, 0.5 * width};
    const Mesh mesh(
        TriangleSoup{{tip, side, opposite(side), opposite(tip)}, {{0, 1, 2}, {3, 2, 1}}});
    const auto straight = static_cast<double>(straight_distance(mesh, 0, 3));
    const double distance = BruteForce(mesh).distances(std::vector<Source>{{.at = 0}})[3];
    EXPECT_NEAR(distance, straight, 1e-15 * straight) << width;
  }
}

}  // namespace
}  // namespace geodesic
