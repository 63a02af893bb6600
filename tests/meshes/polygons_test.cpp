// Polygons of files become triangles that cover them once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshes/load.h"
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

// The tetrahedron, with one face of each number of corners below three, in every format of
// polygons.
std::vector<std::pair<std::string, std::string>> with_short_faces() {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string corners = "2 1 3\n1 2\n0\n";
  std::string off = binary_off();
  off[off.find('\4', off.find('\4') + 1)] = '\7';
  std::string ply = replaced(binary_ply<float>(std::endian::little), "face 4", "face 7");
  for (const int number : {2, 1, 3, 0, 1, 2, 0, 0, 0}) off += bytes_of(number, std::endian::big);
  for (const auto& [count, vertices] :
       std::vector<std::pair<char, std::vector<int>>>{{2, {1, 3}}, {1, {2}}, {0, {}}}) {
    ply += count;
    for (const int v : vertices) ply += bytes_of(v);
  }
  return {{"a.obj", kObj + "f 2 4\nf 3\nf\n"},
          {"a.off", replaced(kOff, "4 4 6", "4 7 6") + corners},
          {"binary.off", off},
          {"ascii.ply", replaced(kPly, "face 4", "face 7") + corners},
          {"binary.ply", ply}};
}

TEST(Polygons, OfFewerThanThreeCornersAreFacesThatARepairDrops) {
  for (const auto& [name, bytes] : with_short_faces()) {
    const MeshFile file = parse_mesh(bytes, name);
    std::vector<Triangle> expected = tetrahedron().triangles;
    expected.insert(expected.end(), {{1, 3, 3}, {2, 2, 2}, {0, 0, 0}});
    EXPECT_EQ(file.soup.triangles, expected) << name;
    EXPECT_THROW(load_mesh(file, name, {}), MeshError) << name;
    EXPECT_EQ(load_mesh(file, name, {.repair = true}).soup.triangles, tetrahedron().triangles)
        << name;
  }
}

TEST(Polygons, ConvexOnesAreFansFromTheirFirstCorner) {
  const MeshFile file = parse({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(file.soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Polygons, OnesSeenWholeFromACornerAreCoveredOnceWhicheverComesFirst) {
  const std::vector<std::pair<Polygon, double>> polygons = {
      {{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, 1},  // an arrow head
      {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2.5, 0}}, 3.25},  // an L
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

TEST(Polygons, OnesWithoutSuchACornerAreReported) {
  const Polygon crossing = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  const Polygon u = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0},
                     {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const Polygon without_area = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  for (const Polygon& polygon : {crossing, u, without_area}) {
    const MeshFile file = parse(polygon);
    EXPECT_EQ(file.soup.triangles.size(), polygon.size() - 2);
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_TRUE(contains(file.warnings[0], "may be folded: triangulate")) << file.warnings[0];
    const std::string line = "line " + std::to_string(polygon.size() + 1);
    EXPECT_TRUE(contains(file.warnings[0], line)) << file.warnings[0];
  }
}

TEST(Polygons, OfManyCornersTakeLittleTime) {
  Polygon comb;
  constexpr int kTeeth = 50000;
  for (int i = 0; i < kTeeth; ++i) {
    comb.push_back({2.0 * i, 1, 0});
    comb.push_back({2.0 * i + 1, 0, 0});
  }
  comb.push_back({kTeeth, 5, 0});
  EXPECT_EQ(parse(comb).soup.triangles.size(), comb.size() - 2);
}

}  // namespace
}  // namespace geodesic
