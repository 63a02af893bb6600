// Polygons of files become triangles that cover them once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshes/mesh_file.h"
#include "solvers/core/geometry.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

using Polygon = std::vector<Vec3>;

MeshFile parse(const Polygon& polygon) {
  std::string text;
  std::string face = "f";
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    text += "v";
    for (const double c : polygon[i]) text.append(" ").append(std::to_string(c));
    text += "\n";
    face.append(" ").append(std::to_string(i + 1));
  }
  return parse_mesh(text + face + "\n", "polygon.obj");
}

struct Areas {
  double signed_sum = 0;  // along the z axis
  double absolute_sum = 0;
};

Areas areas(const TriangleSoup& soup) {
  Areas areas;
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 normal = cross(subtract(soup.positions[b], soup.positions[a]),
                              subtract(soup.positions[c], soup.positions[a]));
    areas.signed_sum += normal[2] / 2;
    areas.absolute_sum += std::abs(normal[2]) / 2;
  }
  return areas;
}

TEST(Polygons, ConvexOnesAreFansFromTheirFirstCorner) {
  const MeshFile file = parse({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Polygons, NonConvexOnesAreCoveredOnceWhicheverCornerComesFirst) {
  const std::vector<std::pair<Polygon, double>> polygons = {
      {{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, 1},  // an arrow head
      {{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 7},
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, 3},
  };
  for (const auto& [polygon, area] : polygons) {
    for (std::size_t first = 0; first < polygon.size(); ++first) {
      Polygon turned = polygon;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                  turned.end());
      const MeshFile file = parse(turned);
      EXPECT_EQ(file.soup.triangles.size(), polygon.size() - 2);
      EXPECT_DOUBLE_EQ(areas(file.soup).signed_sum, area) << "first corner " << first;
      EXPECT_DOUBLE_EQ(areas(file.soup).absolute_sum, area) << "first corner " << first;
      EXPECT_TRUE(file.warnings.empty());
    }
  }
}

TEST(Polygons, ClockwiseOnesStayClockwise) {
  const MeshFile file = parse({{0, 2, 0}, {0.5, 0.5, 0}, {2, 0, 0}, {0, 0, 0}});
  EXPECT_DOUBLE_EQ(areas(file.soup).signed_sum, -1);
  EXPECT_DOUBLE_EQ(areas(file.soup).absolute_sum, 1);
}

TEST(Polygons, ASlitToAHoleIsWalkedTwice) {
  // A square of side 4 with a square hole of side 2, joined by a slit from (0,0) to (1,1).
  const MeshFile file = parse_mesh(
      "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n"
      "f 1 2 3 4 1 5 6 7 8 5\n",
      "slit.obj");
  EXPECT_DOUBLE_EQ(areas(file.soup).signed_sum, 12);
  EXPECT_DOUBLE_EQ(areas(file.soup).absolute_sum, 12);
}

TEST(Polygons, OnesThatCrossThemselvesAreReported) {
  const MeshFile file = parse({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}});
  EXPECT_EQ(file.soup.triangles.size(), 2u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_TRUE(contains(file.warnings[0], "cross themselves")) << file.warnings[0];
  EXPECT_TRUE(contains(file.warnings[0], "line 5")) << file.warnings[0];
}

TEST(Polygons, ManyCornersAreTriangulatedUnlessEarsWouldTakeTooLong) {
  const auto comb = [](std::size_t teeth) {
    Polygon polygon;
    for (std::size_t i = 0; i < teeth; ++i) {
      polygon.push_back({static_cast<double>(2 * i), 1, 0});
      polygon.push_back({static_cast<double>(2 * i + 1), 0, 0});
    }
    polygon.push_back({static_cast<double>(2 * teeth), 1, 0});
    polygon.push_back({static_cast<double>(teeth), 5, 0});
    return polygon;
  };
  const MeshFile file = parse(comb(300));
  EXPECT_EQ(file.soup.triangles.size(), 600u);
  EXPECT_NEAR(areas(file.soup).absolute_sum, 300 + 4 * 600 / 2, 1e-6);
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_THROW(parse(comb(6000)), MeshError);
}

// Corners that go round a triangle again and again, each of them blocked by the last but one, stand
// before the ears. Looking at all corners for each blocked one for each ear took minutes.
TEST(Polygons, CornersThatAreBlockedAreNotLookedAtAgainForEveryEar) {
  constexpr int kRound = 3000, kArc = 3000;
  Polygon polygon;
  for (int i = 0; i < kRound; ++i) polygon.push_back({i % 3 / 2.0, i % 3 == 1 ? 2.0 : 0.0, 0});
  std::reverse(polygon.begin(), polygon.end());  // counter-clockwise
  for (int i = 0; i < kArc; ++i) {
    const double angle = 2.5 * i / kArc - 1.5;
    polygon.push_back({10 + 10 * std::cos(angle), 10 * std::sin(angle) - 5, 0});
  }
  polygon.push_back({0.5, 0.5, 0});
  polygon.push_back(polygon[kRound - 1]);
  EXPECT_EQ(parse(polygon).soup.triangles.size(), polygon.size() - 2);
}

}  // namespace
}  // namespace geodesic
