// Brute force where its own digits are short.
#include <gtest/gtest.h>

#include "meshes/oracles/brute_force.h"

namespace geodesic {
namespace {

// Two needles in one plane that share their short side, through whose middle the way from tip to
// tip leads.
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
