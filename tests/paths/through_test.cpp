// Paths through several points, and straightened curves: closed forms, and local properties that
// path_check.h finds without the code under test.
#include "solvers/paths/through.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "harness/verify/path_check.h"
#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/core/registry.h"
#include "solvers/paths/straighten.h"
#include "tests/message_of.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

constexpr double kPi = std::numbers::pi;

Path through(const Mesh& mesh, const std::vector<SurfacePoint>& points,
             const ThroughOptions& options) {
  return path_through(*make_solver("edge-based", mesh), mesh, points, options);
}

constexpr ThroughOptions kLoop{.closed = true, .straighten = true};

double distance_between(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const auto solver = make_solver("edge-based", mesh);
  return solve_paths(*solver, mesh, {.sources = {{.at = a}}, .targets = {b}}).distance_to_target(0);
}

/// The faults of a curve: it must lie in its faces, be as long as it says, straight across edges,
/// and have angles of at least pi at vertices, of a closed curve everywhere.
std::string faults(const Mesh& mesh, const Path& path, bool closed) {
  const Query query{.sources = {{.at = path.points.front().at}}};
  harness::Finding found =
      harness::check_path(mesh, query, path.points.back().at, path.length(), path);
  if (found) return found->what;
  Path all = path;
  if (closed) {
    if (path.points.front().at != path.points.back().at) return "it is not closed";
    append(all, path);  // where it closes too
  }
  found = harness::check_straight(mesh, all);
  return found ? found->what : "";
}

/// A tube whose rings are regular polygons of these radii, one unit apart.
TriangleSoup tube(Index sides, const std::vector<double>& radii) {
  TriangleSoup soup;
  for (Index ring = 0; ring < radii.size(); ++ring) {
    for (Index k = 0; k < sides; ++k) {
      const double turn = 2 * kPi * k / sides;
      soup.positions.push_back(
          {radii[ring] * std::cos(turn), radii[ring] * std::sin(turn), static_cast<double>(ring)});
      if (ring + 1 == radii.size()) continue;
      const Index a = ring * sides + k, b = ring * sides + (k + 1) % sides;
      soup.triangles.insert(soup.triangles.end(), {{a, b, b + sides}, {a, b + sides, a + sides}});
    }
  }
  return soup;
}

/// How often a closed curve winds around the z axis.
int turns_about_z(const Path& path) {
  double angle = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vec3 &a = path.points[i - 1].position, &b = path.points[i].position;
    angle += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }
  return static_cast<int>(std::lround(angle / (2 * kPi)));
}

/// How often it winds around the circle of radius 1 in the plane z = 0.
int turns_about_tube(const Path& path) {
  double angle = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const auto around = [](const Vec3& p) { return Point2{std::hypot(p[0], p[1]) - 1, p[2]}; };
    const Point2 a = around(path.points[i - 1].position), b = around(path.points[i].position);
    angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return static_cast<int>(std::lround(angle / (2 * kPi)));
}

/// A plate of 3 x 3 squares without the one in the middle; vertex 4 row + column.
TriangleSoup plate_with_hole() {
  TriangleSoup soup;
  for (Index v = 0; v < 16; ++v) {
    soup.positions.push_back({static_cast<double>(v % 4), static_cast<double>(v / 4), 0});
    if (v % 4 == 3 || v / 4 == 3 || v == 5) continue;
    soup.triangles.insert(soup.triangles.end(), {{v, v + 1, v + 5}, {v, v + 5, v + 4}});
  }
  return soup;
}

TEST(PathThrough, is_as_long_as_the_exact_distances_together) {
  const Mesh mesh(generate("icosphere", {{"frequency", 5}}), Numbering::along_surface);
  const std::vector<SurfacePoint> points = {
      3, point_in_face(mesh, 17, {.2, .3, .5}), point_in_face(mesh, 90, {0, .25, .75}), 120, 120,
      8};
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += distance_between(mesh, points[i - 1], points[i]);
  }
  const Path open = through(mesh, points, {});
  EXPECT_NEAR(open.length(), sum, 1e-12 * sum);
  EXPECT_EQ(open.points.front().at, points.front());
  EXPECT_EQ(open.points.back().at, points.back());
  const Path closed = through(mesh, points, {.closed = true});
  sum += distance_between(mesh, points.back(), points.front());
  EXPECT_NEAR(closed.length(), sum, 1e-12 * sum);
  EXPECT_EQ(closed.points.back().at, points.front());
  for (const SurfacePoint& each : points) {
    EXPECT_TRUE(std::ranges::count(closed.points, each, &PathPoint::at) > 0);
  }
  const Query query{.sources = {{.at = points.front()}}};
  EXPECT_FALSE(harness::check_path(mesh, query, points.front(), sum, closed));
}

TEST(PathThrough, is_refused_in_one_line) {
  const Mesh mesh(generate("two-components"));
  const auto message = [&](const std::vector<SurfacePoint>& points, const ThroughOptions& options) {
    return message_of<std::invalid_argument>([&] { through(mesh, points, options); });
  };
  const Index last = mesh.vertex_count() - 1;
  EXPECT_EQ(message({0, 1, last}, {}), "no path leads to vertex " + std::to_string(last));
  EXPECT_EQ(message({0}, {}), "a path through points needs at least two");
  EXPECT_NE(message({0, last + 1}, {}).find("is not in the mesh"), std::string::npos);
  const Mesh flat(
      TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              through(flat, {0, 3}, {.straighten = true});
            }).find("faces without area"),
            std::string::npos);
  const Mesh crossed(band(5, true), Numbering::as_given, NonManifoldEdges::crossed);
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              through(crossed, {0, 3}, {.straighten = true});
            }).find("non-manifold edges"),
            std::string::npos);
}

TEST(Straightened, is_the_straight_line_of_a_plane) {
  const Mesh mesh(generate("grid", {{"columns", 20}, {"rows", 20}}), Numbering::along_surface);
  const std::vector<SurfacePoint> ways[] = {
      {0, 20, 440, 50, 400, 230},
      {point_in_face(mesh, 10, {.2, .3, .5}), 420, 3, point_in_face(mesh, 500, {.5, .5, 0})},
      {7, 300, 7},
      {point_in_face(mesh, 10, {.2, .3, .5}), 420, point_in_face(mesh, 10, {.5, .3, .2})}};
  for (const auto& points : ways) {
    const Path path = through(mesh, points, {.straighten = true});
    const double straight =
        norm(subtract(position_of(mesh, points.front()), position_of(mesh, points.back())));
    EXPECT_NEAR(path.length(), straight, 1e-12 * (1 + straight));
    EXPECT_EQ(path.points.front().position, position_of(mesh, points.front()));
    EXPECT_EQ(path.points.back().position, position_of(mesh, points.back()));
    EXPECT_EQ(faults(mesh, path, false), "");
  }
}

TEST(Straightened, closes_around_a_cylinder_as_often_as_the_curve) {
  const Index sides = 12;
  const Mesh mesh(tube(sides, {1, 1, 1, 1, 1, 1}), Numbering::along_surface);
  const double around = sides * 2 * std::sin(kPi / sides);
  const std::vector<SurfacePoint> once = {13, 13 + 12 + 4, 13 + 24 + 8};
  const std::vector<SurfacePoint> twice = {0, 12 + 4, 24 + 8, 36 + 0, 24 + 4, 12 + 8};
  for (const auto& [points, turns] : {std::pair(once, 1), std::pair(twice, 2)}) {
    const Path path = through(mesh, points, kLoop);
    EXPECT_EQ(turns_about_z(path), turns);
    EXPECT_NEAR(path.length(), turns * around, 1e-12 * around);
    EXPECT_EQ(faults(mesh, path, true), "");
  }
}

TEST(Straightened, winds_as_a_helix_between_its_ends) {
  const Index sides = 12;
  const Mesh mesh(tube(sides, {1, 1, 1, 1, 1, 1}), Numbering::along_surface);
  const double around = sides * 2 * std::sin(kPi / sides);
  const Path path = through(mesh, {0, 4, 8, 12, 16, 20, 60}, {.straighten = true});  // twice
  EXPECT_NEAR(path.length(), std::hypot(2 * around, 5), 1e-12 * around);
  EXPECT_EQ(faults(mesh, path, false), "");
}

TEST(Straightened, is_the_polygon_at_the_waist_of_a_tube) {
  for (const Index sides : {5u, 8u, 31u}) {
    std::vector<double> radii;
    for (int ring = -4; ring <= 4; ++ring) radii.push_back(std::sqrt(1 + ring * ring / 4.));
    const Mesh mesh(tube(sides, radii), Numbering::along_surface);
    const Path path = through(mesh, {0, sides / 3, 2 * sides / 3 + sides}, kLoop);
    const double waist = sides * 2 * std::sin(kPi / sides);
    EXPECT_NEAR(path.length(), waist, 1e-12 * waist);
    EXPECT_EQ(turns_about_z(path), 1);
    EXPECT_EQ(path.points.size(), sides + 1);
    EXPECT_EQ(faults(mesh, path, true), "");
  }
}

TEST(Straightened, is_locally_shortest_on_a_torus_and_keeps_its_class) {
  const Index rings = 24, sides = 12;
  const Mesh mesh(generate("torus", {{"rings", rings}, {"sides", sides}}),
                  Numbering::along_surface);
  const auto vertex = [&](Index ring, Index side) {
    return SurfacePoint(side % sides * rings + ring % rings);
  };
  std::vector<SurfacePoint> hole, tube_loop, knot;
  for (Index i = 0; i < 8; ++i) hole.push_back(vertex(3 * i, i == 3 ? 5 : 2));
  for (Index i = 0; i < 4; ++i) tube_loop.push_back(vertex(i * i, 3 * i));
  for (Index i = 0; i < 24; ++i) knot.push_back(vertex(2 * i, i * 3 * sides / 24));
  for (const auto& points : {hole, tube_loop, knot}) {
    const Path given = through(mesh, points, {.closed = true});
    const Path path = straightened(mesh, given, true);
    EXPECT_EQ(turns_about_z(path), turns_about_z(given));
    EXPECT_EQ(turns_about_tube(path), turns_about_tube(given));
    EXPECT_LE(path.length(), given.length() * (1 + 1e-12));
    EXPECT_EQ(faults(mesh, path, true), "");
  }
  EXPECT_EQ(std::abs(turns_about_z(through(mesh, knot, kLoop))), 2);
  EXPECT_EQ(std::abs(turns_about_tube(through(mesh, knot, kLoop))), 3);
  // The loop around the hole becomes the inner polygon.
  const double inner = rings * 2 * .6 * std::sin(kPi / rings);
  EXPECT_NEAR(through(mesh, hole, kLoop).length(), inner, 1e-12 * inner);
  // The loop around the tube is that across the sides of one ring of vertices.
  const double round_tube = sides * 2 * .4 * std::sin(kPi / sides);
  EXPECT_NEAR(through(mesh, tube_loop, kLoop).length(), round_tube, .05 * round_tube);
}

TEST(Straightened, is_the_rim_of_a_hole) {
  const Mesh mesh(plate_with_hole());
  const Path path = through(mesh, {0, 3, 15, 12}, kLoop);
  EXPECT_NEAR(path.length(), 4, 1e-14);
  EXPECT_EQ(faults(mesh, path, true), "");
  const Path twice = through(mesh, {0, 3, 15, 12, 0, 3, 15, 12}, kLoop);
  EXPECT_NEAR(twice.length(), 8, 1e-14);
  const Path from_corner = through(mesh, {0, 3, 15, 12, 0}, {.straighten = true});
  EXPECT_NEAR(from_corner.length(), 2 + 2 * std::sqrt(5), 1e-13);
}

// Two squares share vertex 2 only: a curve through both stays there, unless it returns.
TEST(Straightened, leaves_the_vertex_between_two_fans_when_it_turns_back_there) {
  const Mesh mesh(
      TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                   {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}}});
  EXPECT_NEAR(through(mesh, {1, 5, 3}, {.straighten = true}).length(), std::sqrt(2), 1e-15);
  EXPECT_NEAR(through(mesh, {1, 0, 3, 4}, {.straighten = true}).length(), 2, 1e-15);
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              through(mesh, {1, 5, 3}, kLoop);
            }).find("shrinks"),
            std::string::npos);
}

TEST(Straightened, says_that_a_loop_shrinks_to_a_point) {
  const std::string shrinks = "the loop shrinks to a point: it can be contracted on this surface";
  const auto message = [](const Mesh& mesh, const std::vector<SurfacePoint>& points) {
    return message_of<std::invalid_argument>([&] { through(mesh, points, kLoop); });
  };
  const Mesh plane(generate("grid", {{"columns", 9}, {"rows", 9}}));
  EXPECT_EQ(message(plane, {11, 18, 88, 81}), shrinks);
  EXPECT_EQ(message(plane, {11, 18}), shrinks);
  EXPECT_EQ(message(plane, {11, 11}), shrinks);
  EXPECT_EQ(
      message(plane, {point_in_face(plane, 0, {.6, .2, .2}), point_in_face(plane, 0, {.2, .6, .2}),
                      point_in_face(plane, 0, {.2, .2, .6})}),
      shrinks);
  const Mesh hill(tube(9, {1, 2, 3, 4}));  // a loop beside the hole
  EXPECT_EQ(message(hill, {18, 19, 28}), shrinks);
  const Mesh ball(generate("icosphere", {{"frequency", 4}}));
  EXPECT_EQ(message(ball, {0, 20, 30}), shrinks);
}

// All loops on a closed surface without handles contract; a closed geodesic stops them.
TEST(Straightened, stops_at_a_closed_geodesic_around_a_box) {
  const Mesh mesh(generate("box", {{"x-cells", 2}, {"y-cells", 3}, {"z-cells", 4}}),
                  Numbering::along_surface);
  const auto at = [&](const Vec3& place) {
    Index v = 0;
    while (norm(subtract(position_of(mesh, v), place)) > 1e-9) ++v;
    return SurfacePoint(v);
  };
  const Path path =
      through(mesh, {at({0, 0, 2}), at({2, 0, 2}), at({2, 3, 1}), at({0, 3, 2})}, kLoop);
  EXPECT_NEAR(path.length(), 10, 1e-12);
  EXPECT_EQ(faults(mesh, path, true), "");
}

TEST(Straightened, is_straight_and_not_longer_on_random_meshes) {
  int loops = 0;
  for (const auto& [name, soup] : random_meshes()) {
    const Mesh mesh(soup, Numbering::along_surface);
    if (mesh.has_degenerate_faces()) continue;
    const Index count = mesh.vertex_count();
    for (Index k = 0; k < 6; ++k) {
      const std::vector<SurfacePoint> points = {k % count, (7 * k + 3) % count,
                                                (13 * k + 5) % count, (k + count / 2) % count};
      Path given;
      try {
        given = through(mesh, points, {.closed = k % 2 == 0});
      } catch (const std::invalid_argument&) {
        continue;  // in different components
      }
      try {
        const Path path = straightened(mesh, given, k % 2 == 0);
        EXPECT_LE(path.length(), given.length() * (1 + 1e-12)) << name;
        EXPECT_EQ(faults(mesh, path, k % 2 == 0), "") << name << " " << k;
        ++loops;
      } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("shrinks"), std::string::npos) << name;
      }
    }
  }
  EXPECT_GT(loops, 20);
}

}  // namespace
}  // namespace geodesic
