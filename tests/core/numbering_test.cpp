#include "solvers/core/numbering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshes/random.h"

namespace geodesic {
namespace {

std::vector<Vec3> random_points(Index count, double size) {
  Random random(5);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    for (double& c : p) c = random.between(-size, size);
  }
  return points;
}

bool is_permutation_of_all(std::vector<Index> order, std::size_t count) {
  std::sort(order.begin(), order.end());
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index{0});
  return order == all;
}

std::vector<Index> order_along_curve(const std::vector<Vec3>& points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::transform(cells_along_curve(points, order), order.begin(), &OnCurve::vertex);
  return order;
}

TEST(OrderAlongCurve, holds_every_vertex_once_whatever_the_extent) {
  for (const double size : {0.0, 1e-300, 1.0, 1e308}) {
    EXPECT_TRUE(is_permutation_of_all(order_along_curve(random_points(1000, size)), 1000)) << size;
  }
  EXPECT_TRUE(order_along_curve({}).empty());
}

TEST(OrderAlongCurve, keeps_the_given_order_of_equal_points) {
  const std::vector<Vec3> same(100, Vec3{1, 2, 3});
  const std::vector<Index> order = order_along_curve(same);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(OrderAlongCurve, puts_neighbours_of_a_grid_a_tenth_as_far_apart_as_chance) {
  const std::vector<Vec3> points = random_points(20000, 1);
  const std::vector<Index> order = order_along_curve(points);
  double along = 0, chance = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto distance = [&](Index a, Index b) {
      return std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1],
                        points[a][2] - points[b][2]);
    };
    along += distance(order[i - 1], order[i]);
    chance += distance(static_cast<Index>(i - 1), static_cast<Index>(i));
  }
  EXPECT_LT(along, 0.1 * chance);
}

// Two groups of points and another point, so far from each other that each group lies in one cell.
TEST(OrderAlongCurve, of_groups_far_from_each_other_is_that_of_each_alone) {
  std::vector<Vec3> near = random_points(1000, 1);
  for (Vec3& p : near) {
    for (double& c : p) c = std::round(c * 0x1p20) * 0x1p-20;  // exact far away, too
  }
  std::vector<Vec3> both = near;
  for (const Vec3& p : near) both.push_back(add(p, {0x1p20, 0x1p20, 0x1p20}));
  std::vector<Index> expected = order_along_curve(near);
  for (Index i = 0; i < near.size(); ++i) expected.push_back(expected[i] + 1000);
  both.push_back({0x1p21, 0x1p21, 0x1p21});
  expected.push_back(2000);
  EXPECT_EQ(order_along_curve(both), expected);
}

// Each point is a thousand times as far away as the one before.
TEST(OrderAlongCurve, holds_every_vertex_once_where_boxes_lie_inside_each_other) {
  std::vector<Vec3> points(2000, Vec3{1, 2, 3});
  for (int i = 0; i < 90; ++i) points.push_back({std::pow(1e3, i - 45), 0, 0});
  EXPECT_TRUE(is_permutation_of_all(order_along_curve(points), points.size()));
}

TEST(OrderByLeastVertex, sorts_faces_and_keeps_the_order_of_equal_ones) {
  const std::vector<Triangle> triangles{{3, 2, 4}, {4, 0, 1}, {2, 3, 5}, {1, 5, 0}};
  EXPECT_EQ(order_by_least_vertex(triangles, 6), (std::vector<Index>{1, 3, 0, 2}));
}

}  // namespace
}  // namespace geodesic
