// Straightest lines and polar coordinates: closed forms, and each against the other.
#include "solvers/paths/straightest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/core/registry.h"
#include "tests/message_of.h"

namespace geodesic {
namespace {

const TriangleSoup kTetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}};

TriangleSoup plane() { return generate("grid", {{"columns", 20}, {"rows", 20}}); }

double between(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

Vec3 along(const Mesh& mesh, Index face) {  // the direction of angle 0 in a face
  const auto [a, b, c] = soup_of(mesh).triangles[face];
  const Vec3 side = subtract(position_of(mesh, b), position_of(mesh, a));
  return scale(1 / norm(side), side);
}

TEST(StraightestLine, is_the_straight_line_of_a_plane) {
  const Mesh mesh(plane(), Numbering::along_surface);
  const Index face = 420;
  for (const SurfacePoint begin :
       {point_in_face(mesh, face, {.2, .3, .5}), point_in_face(mesh, face, {.5, .5, 0}),
        SurfacePoint(soup_of(mesh).triangles[face][0])}) {
    const Vec3 from = position_of(mesh, begin);
    for (int i = 0; i < 97; ++i) {
      const double turn = 2 * std::numbers::pi * i / 96, length = 4.5;
      const Vec3 to = add(from, {length * std::cos(turn), length * std::sin(turn), 0});
      const double angle = angle_of(mesh, begin, subtract(to, from));
      const StraightestLine line = trace_straightest(mesh, begin, angle, length);
      ASSERT_FALSE(line.ends_at_boundary);
      EXPECT_NEAR(line.length(), length, 1e-12);
      EXPECT_LT(between(line.points.back().position, to), 1e-12) << i;
      for (const PathPoint& point : line.points) {
        EXPECT_NEAR(between(point.position, from), point.travelled, 1e-12);
      }
    }
  }
}

TEST(StraightestLine, begins_at_the_first_side_of_a_face_and_turns_counter_clockwise) {
  const Mesh mesh(plane(), Numbering::along_surface);
  const SurfacePoint begin = point_in_face(mesh, 421, {1, 1, 1});
  const Vec3 x = along(mesh, 421), y = {-x[1], x[0], 0};
  const StraightestLine line = trace_straightest(mesh, begin, std::numbers::pi / 6, 1);
  const Vec3 to = add(add(position_of(mesh, begin), scale(std::sqrt(3) / 2, x)), scale(.5, y));
  EXPECT_LT(between(line.points.back().position, to), 1e-14);
}

TEST(StraightestLine, leaves_the_same_angle_on_both_sides_of_a_vertex) {
  const Mesh mesh(kTetrahedron);
  const double side = std::sqrt(8), to_middle = side * std::sqrt(3) / 2;
  const double angle = angle_of(mesh, 0, subtract(mesh.position(1), mesh.position(0)));
  const StraightestLine line = trace_straightest(mesh, 0, angle, side + to_middle);
  ASSERT_GE(line.points.size(), 3u);
  EXPECT_EQ(line.points[1].at, SurfacePoint(1));
  EXPECT_LT(between(line.points.back().position, {-1, 0, 0}), 1e-12);  // of the edge 2-3
  EXPECT_NEAR(total_angle(mesh, 1), std::numbers::pi, 1e-14);
}

TEST(StraightestLine, ends_at_the_boundary_and_says_so) {
  const Mesh mesh(plane());
  const Box box = box_around(mesh.positions());
  const SurfacePoint begin = point_in_face(mesh, 300, {1, 1, 1});
  const Vec3 from = position_of(mesh, begin);
  const StraightestLine line =
      trace_straightest(mesh, begin, angle_of(mesh, begin, {1, 0, 0}), 1e3);
  EXPECT_TRUE(line.ends_at_boundary);
  EXPECT_NEAR(line.length(), box.high[0] - from[0], 1e-12);
  const StraightestLine none = trace_straightest(mesh, begin, 1, 0);
  EXPECT_FALSE(none.ends_at_boundary);
  EXPECT_EQ(none.length(), 0);
}

TEST(StraightestLine, has_its_length_on_faces_without_area_too) {
  const TriangleSoup soups[] = {with_flat_caps(rough_sphere(5, 2, .3), 1, 3),
                                with_missing_faces(rough_sphere(7, 2, .3), 5, 8)};
  for (const TriangleSoup& soup : soups) {
    const Mesh mesh(soup, Numbering::along_surface);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.outgoing(mesh.numbers().internal_vertex(v)).empty()) continue;
      for (const double angle : {0., 1., 2.5}) {
        const StraightestLine line = trace_straightest(mesh, v, angle, 7);
        EXPECT_TRUE(line.ends_at_boundary || std::abs(line.length() - 7) < 1e-12);
        double length = 0;
        for (std::size_t i = 1; i < line.points.size(); ++i) {
          length += between(line.points[i - 1].position, line.points[i].position);
        }
        EXPECT_NEAR(length, line.length(), 1e-9);
      }
    }
  }
}

TEST(LogMap, is_polar_coordinates_on_a_plane) {
  const Mesh mesh(plane(), Numbering::along_surface);
  for (const SurfacePoint source : {SurfacePoint(220), point_in_face(mesh, 400, {.2, .3, .5})}) {
    const Vec3 from = position_of(mesh, source);
    const auto solver = make_solver("edge-based", mesh);
    const auto map = log_map(solve_paths(*solver, mesh, {.sources = {{.at = source}}}));
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Vec3 to = subtract(position_of(mesh, v), from);
      EXPECT_NEAR(map[v].length, norm(to), 1e-12);
      if (norm(to) == 0) continue;
      const double off = std::abs(map[v].angle - angle_of(mesh, source, to));
      EXPECT_LT(std::min(off, 2 * std::numbers::pi - off), 1e-11) << v;
    }
  }
}

TEST(LogMap, goes_through_the_angles_of_a_cone) {
  TriangleSoup cone{{{0, 0, 1}}, {}};
  const Index sides = 7;
  for (Index k = 0; k < sides; ++k) {
    const double turn = 2 * std::numbers::pi * k / sides;
    cone.positions.push_back({std::cos(turn), std::sin(turn), 0});
    cone.triangles.push_back({0, 1 + k, 1 + (k + 1) % sides});
  }
  const Mesh mesh(cone);
  const double part = total_angle(mesh, 0) / sides;
  const auto solver = make_solver("edge-based", mesh);
  const auto map = log_map(solve_paths(*solver, mesh, {.sources = {{.at = 0}}}));
  EXPECT_NEAR(part, 2 * std::asin(std::sin(std::numbers::pi / sides) / std::sqrt(2)), 1e-14);
  for (Index k = 0; k < sides; ++k) {
    EXPECT_NEAR(map[1 + k].angle, k * part, 1e-14);
    EXPECT_NEAR(map[1 + k].length, std::sqrt(2), 1e-14);
  }
}

// A path without a bend is the straightest line in the direction in which it leaves.
TEST(LogMap, leads_every_straightest_line_to_its_vertex) {
  int straight = 0;
  for (const auto& [name, soup] : random_meshes()) {
    const Mesh mesh(soup, Numbering::along_surface);
    const auto solver = make_solver("edge-based", mesh);
    for (const SurfacePoint source :
         {SurfacePoint(mesh.vertex_count() / 2), point_in_face(mesh, 3, {.2, .3, .5}),
          point_on_edge(mesh, soup.triangles[5][0], soup.triangles[5][1], .3)}) {
      const Paths paths = solve_paths(*solver, mesh, {.sources = {{.at = source}}});
      const auto map = log_map(paths);
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        if (map[v].length == kInfinity) continue;
        const Path path = paths.to_vertex(v);
        bool bends = path.points.size() < 2;
        for (std::size_t i = 1; i + 1 < path.points.size(); ++i) {
          bends = bends || path.points[i].at.is_vertex();
        }
        if (bends) continue;
        const StraightestLine line = trace_straightest(mesh, source, map[v].angle, map[v].length);
        EXPECT_LT(between(line.points.back().position, position_of(mesh, v)), 1e-9) << name << v;
        ++straight;
      }
    }
  }
  EXPECT_GT(straight, 500);
}

TEST(StraightestLine, is_refused_in_one_line) {
  const TriangleSoup three_faces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                                 {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  const Mesh mesh(plane()), crossed(three_faces, Numbering::as_given, NonManifoldEdges::crossed);
  TriangleSoup with_isolated = plane();
  with_isolated.positions.push_back({9, 9, 9});
  const Mesh isolated(with_isolated);
  const auto refusal = [](const auto& call) { return message_of<std::invalid_argument>(call); };
  EXPECT_EQ(
      refusal([&] { trace_straightest(mesh, 9999, 0, 1); }),
      "vertex 9999 is not in the mesh of " + std::to_string(mesh.vertex_count()) + " vertices");
  EXPECT_EQ(refusal([&] { trace_straightest(mesh, 0, kInfinity, 1); }),
            "the angle of a direction must be finite");
  EXPECT_EQ(refusal([&] { trace_straightest(mesh, 0, 0, -1); }),
            "the length of a line must be from 0 to 10^7 times the mean edge length");
  EXPECT_EQ(refusal([&] {
              angle_of(mesh, 30, {0, 0, 2});
            }),
            "the direction is perpendicular to the surface at vertex 30");
  EXPECT_EQ(refusal([&] {
              angle_of(mesh, 0, {-1, -1, 0});
            }),
            "the direction leads off the surface at vertex 0");
  EXPECT_EQ(refusal([&] { angle_of(mesh, 0, {0, 0, 0}); }), "a direction must be finite and not 0");
  EXPECT_EQ(refusal([&] { trace_straightest(isolated, isolated.vertex_count() - 1, 0, 1); }),
            "vertex " + std::to_string(isolated.vertex_count() - 1) +
                " has no face, and so no directions");
  const Mesh collapsed(with_collapsed_edges(rough_torus(2, 12, 8, .2), 3, 1));
  EXPECT_EQ(refusal([&] { trace_straightest(collapsed, 0, 0, 1); }),
            "at vertex 0 an edge without a length has no direction");
  EXPECT_EQ(refusal([&] { total_angle(crossed, 0); }),
            "a mesh whose paths cross non-manifold edges has no orientation for angles");
}

}  // namespace
}  // namespace geodesic
