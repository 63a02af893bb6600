// Isolines follow the distances of the vertices: they are where the level is, close or end at the
// border, and pass vertices at the level.
#include "meshes/isolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meshes/connectivity.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/message_of.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

double gap(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

// A square from -half to half around the origin in cells of two triangles, and the distances from
// its middle.
struct Square {
  explicit Square(int half, double cell = 1) {
    const int side = 2 * half + 1;
    for (int y = -half; y <= half; ++y) {
      for (int x = -half; x <= half; ++x) {
        soup.positions.push_back({x * cell, y * cell, 0});
        distances.push_back(norm(soup.positions.back()));
        if (x == half || y == half) continue;
        const Index v = static_cast<Index>(soup.positions.size() - 1), up = v + Index(side);
        soup.triangles.push_back({v, v + 1, up + 1});
        soup.triangles.push_back({v, up + 1, up});
      }
    }
  }
  TriangleSoup soup;
  std::vector<double> distances;
};

double interpolated(const Mesh& mesh, const std::vector<double>& distances,
                    const SurfacePoint& point) {
  if (point.is_vertex()) return distances[point.vertex];
  const Triangle corners = soup_of(mesh).triangles[point.face];
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += point.weights[k] * distances[corners[k]];
  return sum;
}

// Whether the point is on an edge of one face, or at the end of one.
bool is_on_boundary(const Mesh& mesh, const SurfacePoint& given) {
  const InternalPoint point = in_internal_numbers(mesh, given);
  if (point.is_vertex()) return mesh.is_boundary(point.vertex);
  return mesh.twin(edge_under(point)) == kNone;
}

void expect_lines(const Mesh& mesh, const std::vector<double>& distances,
                  const std::vector<double>& levels) {
  const TriangleSoup soup = soup_of(mesh);
  const std::vector<Isoline> lines = isolines(mesh, distances, levels);
  std::set<std::pair<double, Index>> passed;
  for (const Isoline& line : lines) {
    ASSERT_GT(line.points.size(), 1u);
    EXPECT_EQ(line.closed, line.points.front().at == line.points.back().at);
    for (const PathPoint* end : {&line.points.front(), &line.points.back()}) {
      EXPECT_TRUE(line.closed || is_on_boundary(mesh, end->at));
    }
    double length = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const PathPoint& point = line.points[i];
      EXPECT_NEAR(interpolated(mesh, distances, point.at), line.level, 1e-12 * line.level);
      EXPECT_LT(gap(point.position, position_of(mesh, point.at)), 1e-12);
      EXPECT_DOUBLE_EQ(point.travelled, length);
      if (i + 1 == line.points.size()) {
        EXPECT_EQ(point.face, kNone);
        break;
      }
      const PathPoint& next = line.points[i + 1];
      EXPECT_FALSE(point.at.is_vertex() && point.at == next.at);
      EXPECT_TRUE(passed.emplace(line.level, point.face).second);
      length += gap(point.position, next.position);
      // Both ends lie in the face: their distances from it vanish.
      const auto& [a, b, c] = soup.triangles[point.face];
      const Vec3 ab = subtract(soup.positions[b], soup.positions[a]);
      const Vec3 ac = subtract(soup.positions[c], soup.positions[a]);
      for (const PathPoint* end : {&point, &next}) {
        const Vec3 to = subtract(end->position, soup.positions[a]);
        EXPECT_NEAR(dot(cross(ab, ac), to), 0, 1e-12);
      }
    }
    EXPECT_DOUBLE_EQ(line.length(), length);
  }
  // Every face in whose interior the level is has its piece.
  for (const double level : levels) {
    for (Index f = 0; f < soup.triangles.size(); ++f) {
      const auto [least, most] =
          std::minmax({distances[soup.triangles[f][0]], distances[soup.triangles[f][1]],
                       distances[soup.triangles[f][2]]});
      if (least < level && level < most && most < kInfinity) {
        EXPECT_TRUE(passed.contains({level, f})) << "face " << f << ", level " << level;
      }
    }
  }
}

TEST(Isolines, close_or_end_at_the_boundary_of_random_meshes) {
  for (const NamedMesh& each : random_meshes()) {
    SCOPED_TRACE(each.name);
    const Mesh mesh(each.soup, Numbering::along_surface);
    const std::vector<Source> sources{{.at = 0}};
    const std::vector<double> distances = BruteForce(mesh).distances(sources);
    expect_lines(mesh, distances, equal_levels(distances, 9));
    std::set<double> through_vertices(distances.begin(), distances.end());
    through_vertices.erase(0);
    through_vertices.erase(kInfinity);
    expect_lines(mesh, distances, {through_vertices.begin(), through_vertices.end()});
  }
}

TEST(Isolines, of_a_plane_are_circles_within_the_square_of_the_edge_length) {
  for (const double edge : {0.25, 0.125, 0.0625}) {
    const Square square(static_cast<int>(4 / edge), edge);
    const Mesh mesh(square.soup);
    for (const double level : {1.03, 2.5, 3.7}) {
      const std::vector<Isoline> lines = isolines(mesh, square.distances, {level});
      ASSERT_EQ(lines.size(), 1u);
      EXPECT_TRUE(lines[0].closed);
      for (const PathPoint& point : lines[0].points) {
        EXPECT_NEAR(norm(point.position), level, edge * edge);
      }
      const double circle = 2 * std::numbers::pi * level;
      EXPECT_NEAR(lines[0].length(), circle, circle * edge * edge);
    }
  }
}

TEST(Isolines, turn_counter_clockwise_round_the_source) {
  const Square square(5);
  for (const Isoline& line : isolines(Mesh(square.soup), square.distances, {2.3, 4.9, 6.0})) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const Vec3 turn = cross(line.points[i].position, line.points[i + 1].position);
      EXPECT_GT(turn[2], 0);
    }
  }
}

TEST(Isolines, pass_vertices_at_the_level_without_gaps_and_branches) {
  const Square square(7);
  const std::vector<double> levels{1, std::sqrt(2), 3, 5};  // (3, 4) is at 5, too
  const Mesh mesh(square.soup);
  const std::vector<Isoline> lines = isolines(mesh, square.distances, levels);
  ASSERT_EQ(lines.size(), levels.size());
  for (const Isoline& line : lines) {
    EXPECT_TRUE(line.closed);
    std::size_t at_vertices = 0;
    for (const PathPoint& point : line.points) at_vertices += point.at.is_vertex();
    const Vec3& begin = line.points.front().position;
    const bool twice = line.points.front().at.is_vertex();
    EXPECT_EQ(at_vertices - twice, line.level == 5 ? 12u : 4u) << line.level << begin[0];
  }
  expect_lines(mesh, square.distances, levels);
}

TEST(Isolines, along_edges_are_lines_too) {
  Square square(3);
  for (std::size_t v = 0; v < square.distances.size(); ++v) {
    square.distances[v] = square.soup.positions[v][0] + 3;  // from the left side
  }
  const std::vector<Isoline> lines = isolines(Mesh(square.soup), square.distances, {3.0, 6.0});
  ASSERT_EQ(lines.size(), 2u);
  for (const Isoline& line : lines) {
    EXPECT_FALSE(line.closed);
    EXPECT_EQ(line.length(), 6);
    EXPECT_EQ(line.points.size(), 7u);
  }
}

TEST(Isolines, that_are_one_vertex_are_left_out) {
  const Mesh mesh(fan(6, 0, 0));
  const std::vector<double> distances{2, 1, 1, 1, 1, 1, 1};
  EXPECT_TRUE(isolines(mesh, distances, {2.0}).empty());
  EXPECT_EQ(isolines(mesh, distances, {1.5}).size(), 1u);
}

TEST(Isolines, end_at_faces_with_unreached_vertices) {
  Square square(4);
  for (double& d : square.distances) {
    if (d > 3.2) d = kInfinity;
  }
  const std::vector<Isoline> lines = isolines(Mesh(square.soup), square.distances, {2.9, 1.5});
  std::size_t whole = 0;
  for (const Isoline& line : lines) {
    whole += line.closed;
    EXPECT_EQ(line.closed, line.level == 1.5);
    for (const PathPoint& point : line.points) EXPECT_TRUE(std::isfinite(point.travelled));
  }
  EXPECT_EQ(whole, 1u);
  EXPECT_GT(lines.size(), 1u);
}

TEST(Isolines, end_at_edges_of_more_than_two_faces) {
  // Three pages with the spine from vertex 0 to vertex 1.
  const TriangleSoup book{{{0, 0, 0}, {0, 0, 2}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                          {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}};
  for (const NonManifoldEdges edges : {NonManifoldEdges::cut, NonManifoldEdges::crossed}) {
    const Mesh mesh(book, Numbering::as_given, edges);
    const std::vector<Isoline> lines = isolines(mesh, std::vector<double>{0, 2, 3, 4, 5}, {1.0});
    ASSERT_EQ(lines.size(), 3u);
    for (Index f = 0; f < 3; ++f) {
      EXPECT_EQ(lines[f].points.size(), 2u);
      EXPECT_EQ(lines[f].points[0].face, f);
    }
  }
}

TEST(Isolines, cross_faces_that_have_an_edge_in_one_direction_where_paths_do) {
  const TriangleSoup strip = band(12, true);
  std::vector<double> distances;
  for (std::size_t v = 0; v < strip.positions.size(); ++v) distances.push_back(v % 2 == 0 ? 1 : 3);
  const Mesh crossed(strip, Numbering::along_surface, NonManifoldEdges::crossed);
  const std::vector<Isoline> lines = isolines(crossed, distances, {2.0});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].points.size(), 25u);
  for (Index f = 0; f < 24; ++f) {
    EXPECT_EQ(std::ranges::count(lines[0].points, f, &PathPoint::face), 1) << f;
  }
}

TEST(Isolines, do_not_depend_on_the_numbering_in_memory) {
  const TriangleSoup soup = rough_terrain(5, 30, 30, 2);
  const Mesh given(soup), sorted(soup, Numbering::along_surface);
  std::vector<double> distances;
  for (const Vec3& p : soup.positions) distances.push_back(2 + std::sin(p[0]) * std::sin(p[1]));
  const std::vector<double> levels = equal_levels(distances, 12);
  const auto a = isolines(given, distances, levels), b = isolines(sorted, distances, levels);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(a.size(), 10 * levels.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].level, b[i].level);
    ASSERT_EQ(a[i].points.size(), b[i].points.size());
    for (std::size_t k = 0; k < a[i].points.size(); ++k) {
      EXPECT_EQ(a[i].points[k].position, b[i].points[k].position);
      EXPECT_EQ(a[i].points[k].face, b[i].points[k].face);
    }
  }
}

TEST(Isolines, of_n_levels_cut_the_distances_into_equal_steps) {
  EXPECT_EQ(equal_levels(std::vector<double>{0, 4, 1, kInfinity}, 3),
            (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(equal_levels(std::vector<double>{0, kInfinity}, 3).empty());
}

TEST(Isolines, of_values_that_are_no_distances_are_refused_in_one_line) {
  const Mesh mesh(fan(4, 0, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [&](const std::vector<double>& distances, double level) {
    return message_of<std::invalid_argument>([&] { isolines(mesh, distances, {level}); });
  };
  const std::string level = "the level of an isoline must be a finite distance above 0, not ";
  const std::vector<double> good{0, 1, 1, 1, 1};
  EXPECT_EQ(message(good, nan), level + "nan");
  EXPECT_EQ(message(good, kInfinity), level + "inf");
  EXPECT_EQ(message(good, 0), level + "0");
  EXPECT_EQ(message(good, -0.5), level + "-0.5");
  EXPECT_EQ(message({0, 1, nan, 1, 1}, 1), "the distance of vertex 2 must be 0 or more, not nan");
  EXPECT_EQ(message({0, 1, 1, -1, 1}, 1), "the distance of vertex 3 must be 0 or more, not -1");
  EXPECT_EQ(message({0, 1}, 1), "isolines need one distance a vertex: 2 for 5 vertices");
  EXPECT_EQ(message_of<std::invalid_argument>([&] { equal_levels(good, 0); }),
            "the number of levels must be between 1 and 10000, not 0");
  EXPECT_THROW(equal_levels(good, kMostLevels + 1), std::invalid_argument);
}

}  // namespace
}  // namespace geodesic
