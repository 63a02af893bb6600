// Paths over the links. The conformance properties check that paths lie on the surface.
#include "solvers/paths/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "harness/verify/path_check.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

/// Greatest share by which a link is longer than its line.
constexpr double kLinkRounding = 1.0 / (1 << 17);
constexpr double kExact = 1e-12;

std::vector<NamedMesh> meshes() {
  const TriangleSoup terrain = rough_terrain(3, 20, 20, 0.3);
  return {{"terrain", terrain},
          {"sphere", rough_sphere(32, 3, 0.1)},
          {"icosphere", generate("icosphere")},
          {"grid", generate("grid", {{"columns", 40}, {"rows", 30}})},
          {"flat caps", with_flat_caps(terrain, 3, 3)},
          {"collapsed edges", with_collapsed_edges(terrain, 3, 10)}};
}

/// Points in faces and on edges.
std::vector<SurfacePoint> points_of(const Mesh& mesh, std::size_t count) {
  Random random(7);
  std::vector<SurfacePoint> points;
  while (points.size() < count) {
    std::array<double, 3> weights;
    for (double& w : weights) w = random.between(0, 1);
    if (points.size() % 4 == 0) weights[random.below(3)] = 0;
    points.push_back(point_in_face(mesh, random.below(mesh.given_face_count()), weights));
  }
  return points;
}

Paths paths_by(std::string_view solver, const Mesh& mesh, const Query& query) {
  return solve_paths(*make_solver(solver, mesh), mesh, query);
}

/// From a vertex, from a point of a face, and from more sources than fit a fan finer than links.
std::vector<Query> queries_on(const Mesh& mesh) {
  const std::vector<SurfacePoint> points = points_of(mesh, 48);
  std::vector<Query> queries = {{.sources = {{7}}}, {.sources = {{points[1], 0.5}}}, {}};
  for (Index i = 0; i < 24; ++i) {
    queries.back().sources.push_back({i % 2 == 0 ? points[i] : SurfacePoint(11 * i)});
  }
  for (Query& query : queries) query.targets = {points.begin() + 24, points.end()};
  return queries;
}

void expect_path(const Mesh& mesh, const Query& query, const SurfacePoint& end, double distance,
                 const Path& path, const std::string& what) {
  const double length = path.length() + query.sources.at(path.source).distance;
  EXPECT_LE(length, distance * (1 + kExact)) << what;
  EXPECT_GE(length, distance * (1 - kLinkRounding) * (1 - kExact)) << what;
  const auto wrong = harness::check_path(mesh, query, end, length, path, {.relative = kExact});
  EXPECT_FALSE(wrong) << what << ": " << wrong->what;
}

TEST(StraightGraphPaths, are_as_long_as_distances_up_to_the_rounding_of_links) {
  for (const NamedMesh& each : meshes()) {
    const Mesh mesh(each.soup);
    for (const Query& query : queries_on(mesh)) {
      for (const char* solver : {"straight-graph", "saddle-vertex-graph"}) {
        const std::string what = each.name + " by " + solver;
        const Paths paths = paths_by(solver, mesh, query);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
          const Path path = paths.to_vertex(v);
          expect_path(mesh, query, v, paths.distances()[v], path,
                      what + ", vertex " + std::to_string(v));
          EXPECT_EQ(path.source, paths.nearest_source(v));
        }
        for (std::size_t i = 0; i < query.targets.size(); ++i) {
          expect_path(mesh, query, query.targets[i], paths.distance_to_target(i),
                      paths.to_target(i), what + ", target " + std::to_string(i));
        }
      }
    }
  }
}

// Once as targets of the query, once afterwards.
TEST(StraightGraphPaths, lead_to_points_of_faces_within_half_a_percent_of_the_distance) {
  for (const NamedMesh& each : meshes()) {
    const Mesh mesh(each.soup);
    for (const Query& query : queries_on(mesh)) {
      const Paths paths = paths_by("straight-graph", mesh, query);
      const Paths exact = paths_by("edge-based", mesh, query);
      for (std::size_t i = 0; i < query.targets.size(); ++i) {
        const double right = exact.distance_to_target(i);
        const double later = paths.distance_at(query.targets[i]);
        const std::string what = each.name + ", target " + std::to_string(i);
        EXPECT_GE(paths.distance_to_target(i), right * (1 - kExact)) << what;
        EXPECT_LE(paths.distance_to_target(i), right * 1.005) << what;
        EXPECT_GE(later, right * (1 - kExact)) << what;
        EXPECT_LE(later, right * 1.005) << what;
        expect_path(mesh, query, query.targets[i], later, paths.to_point(query.targets[i]), what);
      }
    }
  }
}

// Lines from vertices between them would be longer.
TEST(StraightGraphPaths, between_points_of_neighbouring_faces_are_straight) {
  const Mesh mesh(generate("grid", {{"columns", 2}, {"rows", 2}}));
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.twin(h) == kNone) continue;
    const SurfacePoint from = point_in_face(mesh, h / 3, {0.3, 0.4, 0.3});
    const SurfacePoint to = point_in_face(mesh, mesh.twin(h) / 3, {0.4, 0.35, 0.25});
    const Query query{.sources = {{from}}, .targets = {to}};
    const Paths paths = paths_by("straight-graph", mesh, query);
    const double line = norm(subtract(position_of(mesh, to), position_of(mesh, from)));
    EXPECT_NEAR(paths.distance_to_target(0), line, kExact);
    EXPECT_EQ(paths.to_target(0).points.size(), 3U);
  }
}

// Seen from a face without area, faces beyond an edge without length lie in no direction.
TEST(StraightGraphPaths, from_a_face_without_area_bend_at_a_collapsed_edge) {
  const Mesh mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1.5, -0.5, 0}, {0.5, 0, 0}},
                   .triangles = {{0, 1, 4}, {1, 0, 2}, {1, 2, 3}}});
  const SurfacePoint from = point_in_face(mesh, 0, {0.125, 0.625, 0.25});
  const SurfacePoint to = point_on_edge(mesh, 1, 3, 0.5);
  const double length = 0.25 + std::sqrt(0.125);
  for (const auto& [a, b] : {std::pair{from, to}, {to, from}}) {
    const Query query{.sources = {{a}}, .targets = {b}};
    const Paths paths = paths_by("straight-graph", mesh, query);
    EXPECT_NEAR(paths.distance_to_target(0), length, kExact);
    EXPECT_NEAR(paths.to_target(0).length(), length, kExact);
  }
}

// Lines from such a point have no direction through the sides that begin there.
TEST(StraightGraphPaths, from_points_of_collapsed_edges_are_nowhere_shorter_than_the_distance) {
  const TriangleSoup tube = generate("needles", {{"sides", 6}, {"rows", 3}});
  Index points = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Mesh mesh(with_collapsed_edges(tube, seed, 8));
    const std::vector<SurfacePoint> targets = points_of(mesh, 30);
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      if (mesh.half_edge(h).length > 0) continue;
      std::array<double, 3> weights = {0, 0, 0};
      weights[h % 3] = 0.6;
      weights[Mesh::next(h) % 3] = 0.4;
      const Query query{.sources = {{point_in_face(mesh, h / 3, weights)}}, .targets = targets};
      const Paths paths = paths_by("straight-graph", mesh, query);
      const Paths exact = paths_by("edge-based", mesh, query);
      ++points;
      for (std::size_t i = 0; i < targets.size(); ++i) {
        EXPECT_GE(paths.distance_to_target(i), exact.distance_to_target(i) * (1 - kExact));
      }
    }
  }
  EXPECT_GT(points, 20U);
}

}  // namespace
}  // namespace geodesic
