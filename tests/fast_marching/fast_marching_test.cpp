// Which vertices split obtuse corners; planar waves are exact, round waves nearly so. The
// conformance properties check the other promises of the solver.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "meshes/generators/generators.h"
#include "solvers/variants/fast_marching/unfolded.h"
#include "tests/solved.h"

namespace geodesic::fast_marching {
namespace {

// A face with an obtuse corner at vertex 0, above half-edge 0 from (0, 0) to (4, 0). A fan of
// triangles with the further vertices `below` lies below this edge.
Mesh corner_above(const std::vector<Vec3>& below, const std::vector<Triangle>& faces) {
  TriangleSoup soup{{{2, 1, 0}, {0, 0, 0}, {4, 0, 0}}, {{1, 2, 0}}};
  soup.positions.insert(soup.positions.end(), below.begin(), below.end());
  soup.triangles.insert(soup.triangles.end(), faces.begin(), faces.end());
  return Mesh(soup);
}

TEST(SplitCorner, finds_the_vertex_beyond_the_opposite_edge) {
  const auto splitter = split_corner(corner_above({{2.1, -3, 0}}, {{2, 1, 3}}), 0);
  ASSERT_TRUE(splitter);
  EXPECT_EQ(splitter->vertex, 3u);
  EXPECT_NEAR(splitter->at.x, 2.1, 1e-15);
  EXPECT_NEAR(splitter->at.y, -3, 1e-15);
}

TEST(SplitCorner, unfolds_on_where_that_vertex_lies_beside_the_section) {
  const Mesh left = corner_above({{0, -2, 0}, {2, -4, 0}}, {{2, 1, 3}, {2, 3, 4}});
  ASSERT_TRUE(split_corner(left, 0));
  EXPECT_EQ(split_corner(left, 0)->vertex, 4u);
  const Mesh right = corner_above({{4, -2, 0}, {2, -4, 0}}, {{2, 1, 3}, {3, 1, 4}});
  ASSERT_TRUE(split_corner(right, 0));
  EXPECT_EQ(split_corner(right, 0)->vertex, 4u);
}

TEST(SplitCorner, unfolds_folded_faces_into_the_plane_of_the_corner) {
  const auto splitter = split_corner(corner_above({{2, 0, 3}}, {{2, 1, 3}}), 0);
  ASSERT_TRUE(splitter);
  EXPECT_NEAR(splitter->at.x, 2, 1e-15);
  EXPECT_NEAR(splitter->at.y, -3, 1e-15);
}

TEST(SplitCorner, finds_none_for_other_corners_and_at_a_boundary) {
  const Mesh mesh = corner_above({{2, -3, 0}}, {{2, 1, 3}});
  for (Index h = 1; h < mesh.half_edge_count(); ++h) EXPECT_FALSE(split_corner(mesh, h)) << h;
  EXPECT_FALSE(split_corner(corner_above({}, {}), 0));
}

/// A grid of unit cells of two right triangles each, sheared along x: rows keep their heights.
TriangleSoup sheared_grid(double shear) {
  TriangleSoup soup = generate("grid", {{"columns", 40}, {"rows", 8}});
  for (Vec3& p : soup.positions) p[0] += shear * p[1];
  return soup;
}

TEST(FastMarching, is_exact_for_planar_waves_through_obtuse_corners_too) {
  Index split = 0;
  for (const double shear : {0.0, 0.4, -0.4, 1.0, -1.7}) {
    const Mesh mesh(sheared_grid(shear));
    for (Index h = 0; h < mesh.half_edge_count(); ++h) split += split_corner(mesh, h) ? 1u : 0u;
    Query query;
    std::vector<Index> tested;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Vec3& p = mesh.position(v);
      if (p[1] == 0) query.sources.push_back({v});
      // Vertices far from the other sides, so that the wave did not come from there.
      const double column = p[0] - shear * p[1];
      if (p[1] > 0 && std::abs(column - 20) < 1 && std::abs(p[0] - 20) < 19) tested.push_back(v);
    }
    const std::vector<double> distances = distances_by("fast-marching", mesh, query);
    EXPECT_GE(tested.size(), 8u) << shear;
    for (const Index v : tested) {
      EXPECT_NEAR(distances[v], mesh.position(v)[1], 1e-12) << shear << ", vertex " << v;
    }
  }
  EXPECT_GT(split, 0u);
}

double mean_error_on_sphere(Index frequency) {
  const Mesh mesh(generate("icosphere", {{"frequency", frequency}}));
  const std::vector<double> distances = distances_by("fast-marching", mesh, {.sources = {{0}}});
  double sum = 0;
  for (Index v = 1; v < mesh.vertex_count(); ++v) {
    const Vec3 a = mesh.position(0), b = mesh.position(v);
    const double angle = std::atan2(norm(cross(a, b)), dot(a, b));
    sum += std::abs(distances[v] / angle - 1);
  }
  return sum / (mesh.vertex_count() - 1);
}

TEST(FastMarching, comes_closer_to_great_circles_on_finer_spheres) {
  const double coarse = mean_error_on_sphere(8), fine = mean_error_on_sphere(32);
  EXPECT_LT(coarse, 0.05);
  EXPECT_LT(fine, coarse / 2);
}

}  // namespace
}  // namespace geodesic::fast_marching
