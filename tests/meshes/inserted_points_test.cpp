#include "meshes/point_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

constexpr double kExact = 1e-12;

// Points in faces and on edges, also next to corners and sides, several at one place.
std::vector<SurfacePoint> points_everywhere(const Mesh& mesh, std::uint64_t seed,
                                            std::size_t count) {
  Random random(seed);
  std::vector<SurfacePoint> points;
  while (points.size() < count) {
    const Index face = random.below(mesh.face_count());
    for (const double share : {0.3, 1e-15, 1e-12, 0.5, 1 - 1e-15}) {
      const double rest = 1 - share, t = random.between(0, 1);
      points.push_back(point_in_face(mesh, face, {share, rest * t, rest * (1 - t)}));
      points.push_back(point_in_face(mesh, face, {rest, 0, share}));
    }
    points.push_back(point_in_face(mesh, face, {1 - 2e-15, 1e-15, 1e-15}));
    points.push_back(points[random.below(static_cast<std::uint32_t>(points.size()))]);
    points.push_back(mesh.triangle(face)[0]);
  }
  return points;
}

// Relative error, also for distances of 0.
double relative_error(double distance, double expected) {
  if (distance == expected) return 0;
  return std::abs(distance - expected) / std::max(std::abs(expected), 1e-300);
}

/// Compares the distances of the vertices that both meshes have.
void expect_same_distances(const Mesh& mesh, const Mesh& finer, const Query& query) {
  const std::vector<double> before = distances_by("edge-based", mesh, query);
  const std::vector<double> after = distances_by("edge-based", finer, query);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LE(relative_error(after[v], before[v]), kExact) << "vertex " << v;
  }
}

TEST(InsertedPoints, are_vertices_where_the_points_lie) {
  for (const NamedMesh& each : random_meshes()) {
    const Mesh mesh(each.soup);
    const std::vector<SurfacePoint> points = points_everywhere(mesh, 1, 100);
    const InsertedPoints inserted(mesh, points);
    for (const SurfacePoint& point : points) {
      const Vec3 is = inserted.mesh().position(inserted.vertex(point));
      EXPECT_LE(norm(subtract(is, position_of(mesh, point))), inserted.place()) << each.name;
    }
  }
}

TEST(InsertedPoints, leave_vertices_their_numbers_and_the_surface_its_shape) {
  for (const NamedMesh& each : random_meshes()) {
    SCOPED_TRACE(each.name);
    const Mesh mesh(each.soup);
    const InsertedPoints inserted(mesh, points_everywhere(mesh, 2, 60));
    const Mesh& finer = inserted.mesh();
    EXPECT_GT(finer.face_count(), mesh.face_count());
    EXPECT_FALSE(finer.has_degenerate_faces());
    const auto euler = [](const Mesh& m) {
      return m.vertex_count() + m.face_count() - m.edge_count();
    };
    EXPECT_EQ(euler(finer), euler(mesh));
    expect_same_distances(mesh, finer, {.sources = {{.at = 0}, {.at = 5, .distance = 0.1}}});
  }
}

// Points of a flat cap lie near the lines of all three edges, and between the ends of two edges.
TEST(InsertedPoints, in_faces_without_height_leave_distances_as_they_are) {
  for (const double height : {0.0, 1e-17, 1e-15}) {
    const Mesh mesh(
        TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}, {0.5, -1, 0}, {0.2, 1, 0}},
                     {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}}});
    std::vector<SurfacePoint> points;
    for (const double share : {0.1, 0.3, 0.6, 0.8}) {
      points.push_back(point_in_face(mesh, 0, {share / 2, 1 - share, share / 2}));
      points.push_back(point_in_face(mesh, 0, {1 - share, share / 2, share / 2}));
    }
    const InsertedPoints inserted(mesh, points);
    for (const Index source : {0u, 3u, 4u}) {
      SCOPED_TRACE("height " + std::to_string(height) + ", source " + std::to_string(source));
      expect_same_distances(mesh, inserted.mesh(), {.sources = {{.at = source}}});
    }
  }
}

TEST(InsertedPoints, of_one_place_are_one_vertex) {
  const Mesh mesh(generate("grid", {{"columns", 2}, {"rows", 2}}));
  const SurfacePoint in_face = point_in_face(mesh, 3, {0.2, 0.3, 0.5});
  const SurfacePoint beside = point_in_face(mesh, 3, {0.2, 0.3 + 1e-16, 0.5 - 1e-16});
  const InsertedPoints inserted(mesh, std::vector{in_face, beside, in_face});
  EXPECT_EQ(inserted.vertex(in_face), inserted.vertex(beside));
  EXPECT_EQ(inserted.mesh().vertex_count(), mesh.vertex_count() + 1);
  EXPECT_THROW(inserted.vertex(point_in_face(mesh, 3, {0.5, 0.3, 0.2})), std::invalid_argument);
}

TEST(InsertedPoints, on_one_edge_from_either_side_split_both_faces) {
  const Mesh mesh(
      TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 3, 0}}});
  const SurfacePoint a = point_in_face(mesh, 0, {0.75, 0, 0.25});  // on the edge 0-2
  const SurfacePoint b = point_in_face(mesh, 1, {0.25, 0, 0.75});
  const SurfacePoint c = point_in_face(mesh, 1, {0.5, 0, 0.5});
  const InsertedPoints inserted(mesh, std::vector{a, b, c});
  EXPECT_EQ(inserted.vertex(a), inserted.vertex(b));
  EXPECT_EQ(inserted.mesh().vertex_count(), 6u);
  EXPECT_EQ(inserted.mesh().face_count(), 6u);
  EXPECT_EQ(inserted.mesh().edge_count(), 11u);  // all twins are linked
}

TEST(InsertedPoints, far_from_the_origin_of_space_keep_their_digits) {
  TriangleSoup soup = generate("grid", {{"columns", 4}, {"rows", 4}});
  for (Vec3& p : soup.positions) p = add(p, {5e5, -4e6, 300});
  const Mesh mesh(soup);
  const std::vector<SurfacePoint> points = points_everywhere(mesh, 3, 20);
  EXPECT_LE(InsertedPoints(mesh, points).place(), 1e-14);
}

// On a flat square, the distances of all points are Euclidean.
TEST(PointSolver, has_exact_distances_from_and_at_any_points) {
  for (const char* solver : {"edge-based", "mmp", "ch", "fwp-ch"}) {
    const Mesh mesh(generate("grid", {{"columns", 4}, {"rows", 5}}), Numbering::along_surface);
    const std::vector<SurfacePoint> points = points_everywhere(mesh, 4, 60);
    PointSolver points_of(solver, mesh, points, points);
    std::vector<double> distances(mesh.vertex_count()), at_targets(points.size());
    for (const SurfacePoint& source : points) {
      const Query query{.sources = {{.at = source, .distance = 0}}, .targets = points};
      points_of.solve(query, distances, at_targets);
      const auto expect = [&](double distance, const SurfacePoint& at) {
        const double straight = norm(subtract(position_of(mesh, at), position_of(mesh, source)));
        EXPECT_LE(std::abs(distance - straight), kExact * straight + 4e-15) << solver;
      };
      for (Index v = 0; v < mesh.vertex_count(); ++v) expect(distances[v], v);
      for (std::size_t i = 0; i < points.size(); ++i) expect(at_targets[i], points[i]);
    }
  }
}

// The weights of a point keep the digits that its position in space has lost.
TEST(PointSolver, keeps_the_digits_of_distances_within_a_face) {
  const Mesh mesh(generate("grid", {{"columns", 2}, {"rows", 2}}));
  const Triangle corners = mesh.triangle(0);
  const double side = norm(subtract(mesh.position(corners[1]), mesh.position(corners[0])));
  const SurfacePoint near = point_on_edge(mesh, corners[0], corners[1], 0x1p-52);
  const SurfacePoint nearer = point_on_edge(mesh, corners[0], corners[1], 0x1p-53);
  const std::vector<SurfacePoint> targets{nearer, corners[0]};
  std::vector<double> distances(mesh.vertex_count()), at_targets(2);
  PointSolver("mmp", mesh, std::vector{near}, targets)
      .solve({.sources = {{.at = near}}, .targets = targets}, distances, at_targets);
  EXPECT_LE(relative_error(at_targets[0], side * 0x1p-53), kExact);
  EXPECT_LE(relative_error(at_targets[1], side * 0x1p-52), kExact);
  EXPECT_LE(relative_error(distances[corners[0]], side * 0x1p-52), kExact);
}

TEST(PointSolver, stops_at_targets_and_limits_as_solvers_do) {
  const Mesh mesh(generate("grid", {{"columns", 6}, {"rows", 6}}));
  const SurfacePoint source = point_in_face(mesh, 0, {1, 1, 1});
  const std::vector<SurfacePoint> targets{point_in_face(mesh, 5, {1, 1, 1})};
  PointSolver solver("mmp", mesh, std::vector{source}, targets);
  std::vector<double> all(mesh.vertex_count()), some(mesh.vertex_count());
  std::vector<double> at(1), limited(1);
  Query query{.sources = {{.at = source}}, .targets = targets};
  solver.solve(query, all, at);
  query.stop_at_targets = true;
  solver.solve(query, some, limited);
  EXPECT_EQ(at, limited);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(some[v], all[v] <= at[0] ? all[v] : kInfinity);
  }
  query.stop_at_targets = false;
  query.limit = at[0] / 2;
  solver.solve(query, some, limited);
  EXPECT_EQ(limited[0], kInfinity);
}

TEST(PointSolver, refuses_points_that_are_not_on_the_mesh) {
  const Mesh mesh(generate("grid", {{"columns", 2}, {"rows", 2}}));
  SurfacePoint nowhere;
  nowhere.face = 8;
  EXPECT_THROW(PointSolver("mmp", mesh, std::vector{nowhere}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace geodesic
