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
  std::vector<Index> order;
  for (const OnCurve& c : cells_along_curve(points)) order.push_back(c.vertex);
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

TEST(OrderByLeastVertex, sorts_faces_and_keeps_the_order_of_equal_ones) {
  const std::vector<Triangle> triangles{{3, 2, 4}, {4, 0, 1}, {2, 3, 5}, {1, 5, 0}};
  EXPECT_EQ(order_by_least_vertex(triangles, 6), (std::vector<Index>{1, 3, 0, 2}));
}

}  // namespace
}  // namespace geodesic
