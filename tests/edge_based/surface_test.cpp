// Sources next to corners, and the end of a propagation over long edges. The tests of all solvers
// for surface points are in tests/surface_points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/random.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

constexpr const char* kSolver = "edge-based";

double space_between(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

/// A square of unit cells whose inner vertices are moved in the plane.
TriangleSoup shaken_square(Index cells) {
  TriangleSoup soup = generate("grid", {{"columns", cells}, {"rows", cells}});
  Random random(5);
  for (Vec3& p : soup.positions) {
    const bool inner = std::min(p[0], p[1]) > 0.5 && std::max(p[0], p[1]) < cells - 0.5;
    if (inner) p = add(p, {random.between(-0.25, 0.25), random.between(-0.25, 0.25), 0});
  }
  return soup;
}

/// The point of the face of h at distance `near` from the origin of h, opposite to vertex w except
/// for a rotation by `turn` radians. Returns no point if it lies outside the face.
SurfacePoint opposite_to(const Mesh& mesh, Index w, Index h, double near, double turn) {
  const Vec3 corner = mesh.position(mesh.origin(h));
  const Vec3 away = subtract(corner, mesh.position(w));
  const double x = away[0] - turn * away[1], y = away[1] + turn * away[0];
  const Vec3 a = subtract(mesh.position(mesh.head(h)), corner);
  const Vec3 b = subtract(mesh.position(mesh.apex(h)), corner);
  const double scale = near / (std::hypot(x, y) * (a[0] * b[1] - a[1] * b[0]));
  const double to_head = (x * b[1] - y * b[0]) * scale, to_apex = (a[0] * y - a[1] * x) * scale;
  SurfacePoint point;
  if (!(to_head > 0 && to_apex > 0)) return point;
  point.face = h / 3;
  point.weights[h % 3] = 1 - to_head - to_apex;
  point.weights[(h + 1) % 3] = to_head;
  point.weights[(h + 2) % 3] = to_apex;
  return point;
}

// Rounding turns the lines that pass the corner on its two sides by up to a radian.
TEST(EdgeBasedSurface, sources_next_to_a_corner_see_what_lies_behind_it) {
  const Mesh mesh(shaken_square(10));
  Random random(1);
  std::vector<double> distances(mesh.vertex_count());
  const auto solver = make_solver(kSolver, mesh);
  for (double near = 1e-16; near < 0.1; near *= 10) {
    for (int left = 60; left > 0;) {
      const Index h = random.below(mesh.half_edge_count()), w = random.below(mesh.vertex_count());
      const double most = std::min(0.5, 3e-16 / near);
      const SurfacePoint at = opposite_to(mesh, w, h, near, random.between(-most, most));
      if (at.face == kNone || mesh.is_boundary(mesh.origin(h)) || !defect_of(mesh, at).empty()) {
        continue;
      }
      --left;
      solver->solve({.sources = {{.at = at}}}, distances);
      const double expected = space_between(mesh.position(w), position_of(mesh, at));
      EXPECT_NEAR(distances[w], expected, 1e-12 * expected + 1e-14)
          << near << " from vertex " << mesh.origin(h) << " to " << w;
    }
  }
}

// A ladder whose vertices are all far away: only windows reach the target.
TEST(EdgeBasedSurface, a_limit_is_reached_over_edges_whose_ends_are_beyond_it) {
  constexpr Index kRungs = 60;
  TriangleSoup soup;
  for (Index i = 0; i <= kRungs; ++i) {
    soup.positions.insert(soup.positions.end(), {{0.1 * i, -50, 0}, {0.1 * i, 50, 0}});
    if (i == 0) continue;
    const Index b = 2 * i, a = b - 2;
    soup.triangles.insert(soup.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
  }
  const Mesh mesh(soup);
  const SurfacePoint from = point_in_face(mesh, 20, {0.5, 0.1, 0.4});
  const SurfacePoint to = point_in_face(mesh, 80, {0.5, 0.1, 0.4});
  const double expected = space_between(position_of(mesh, from), position_of(mesh, to));
  Query query{.sources = {{.at = from}}, .limit = expected + 0.01, .targets = {to}};
  Recording recording;
  recording.kind = RecordingKind::paths;
  const std::vector<double> distances = distances_by(kSolver, mesh, query, &recording);
  EXPECT_NEAR(recording.targets[0].distance, expected, 1e-12);
  EXPECT_EQ(std::ranges::count(distances, kInfinity), 2 * (kRungs + 1));
  // One window per face: 60 faces to the target and a few beyond, 20 to the boundary behind.
  EXPECT_LE(propagated_by(kSolver, mesh, query), 90u);
}

TEST(EdgeBasedSurface, a_limit_does_not_depend_on_how_long_edges_are_elsewhere) {
  const TriangleSoup square = shaken_square(24);
  TriangleSoup spiked = square;
  const Index tip = static_cast<Index>(spiked.positions.size());
  spiked.positions.push_back({-1e3, -1e3, 0});
  spiked.triangles.push_back({1, 0, tip});
  const Index middle = 12 * 25 + 12;
  const Query query{.sources = {{.at = middle}}, .limit = 4};
  const auto windows = [](const TriangleSoup& soup, const Query& asked) {
    return static_cast<double>(propagated_by(kSolver, Mesh(soup), asked));
  };
  const double expected = windows(square, query);
  // Not equal, since the width of the buckets depends on the mean edge length.
  EXPECT_LE(windows(spiked, query), 1.1 * expected);
  EXPECT_LE(expected, 0.3 * windows(square, {query.sources}));
}

}  // namespace
}  // namespace geodesic
