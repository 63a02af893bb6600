// Distances over the links. The conformance properties check that no distance is too short, and all
// other promises of solvers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/delayed_pieces.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

/// Greatest share by which a link is longer than its line.
constexpr double kRounding = 1.0 / (1 << 17);

std::vector<double> solve(std::string_view solver, const Mesh& mesh, Index source) {
  return distances_by(solver, mesh, {.sources = {{source}}});
}

double largest_error(const Mesh& mesh, Index source) {
  const std::vector<double> exact = solve("edge-based", mesh, source);
  const std::vector<double> distances = solve("straight-graph", mesh, source);
  double largest = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (exact[v] > 0) largest = std::max(largest, distances[v] / exact[v] - 1);
  }
  return largest;
}

TEST(StraightGraph, is_nowhere_below_the_distance_and_nowhere_above_that_along_edges) {
  for (const NamedMesh& each : random_meshes()) {
    const Mesh mesh(each.soup);
    const std::vector<double> exact = solve("edge-based", mesh, 0);
    const std::vector<double> distances = solve("straight-graph", mesh, 0);
    const std::vector<double> along_edges = solve("dijkstra", mesh, 0);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_GE(distances[v], exact[v] * (1 - 1e-12)) << each.name << ", vertex " << v;
      EXPECT_LE(distances[v], along_edges[v] * (1 + kRounding + 1e-12))
          << each.name << ", vertex " << v;
    }
  }
}

// From a source beside a short edge, faces a million times as long as wide: the places of the
// edge's ends come from far vertices, and their difference lacks the digits that unfolding needs.
// Distances far shorter than the edges are accurate relative to a 256th of an edge
// (kCoordinateRounding).
TEST(StraightGraph, is_nowhere_below_the_distance_among_needles_in_the_plane) {
  constexpr double kLong = 1.2e6;
  TriangleSoup soup = generate("grid", {{"columns", 5}, {"rows", 12}});
  for (Index v = 0; v < soup.positions.size(); ++v) {
    Vec3& p = soup.positions[v];
    p = {kLong * p[0] + 0.013 * (v * 7 % 11), 0.3 * p[1] + 0.021 * (v * 5 % 13), 0};
  }
  const Mesh mesh(soup);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> weights = {1e-7, 1e-7, 1e-7};
      weights[k] = 1;
      const SurfacePoint source = point_in_face(mesh, f, weights);
      const Vec3 at = position_of(mesh, source);
      const std::vector<double> distances =
          distances_by("straight-graph", mesh, {.sources = {{source}}});
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        const double line = norm(subtract(mesh.position(v), at));
        EXPECT_GE(distances[v], line - 1e-12 * std::max(line, kLong / 256))
            << "face " << f << ", corner " << k << ", vertex " << v;
      }
    }
  }
}

// Squares of side n, each between two of five axes, around a vertex: a cube that stands on a plane.
TEST(StraightGraph, is_exact_up_to_rounding_where_paths_bend_at_a_saddle_vertex) {
  constexpr std::array<Vec3, 5> axes = {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}}};
  constexpr Index n = 6;
  TriangleSoup soup{{{0, 0, 0}}, {}};
  // Vertex i a + j b of quadrant k, i > 0 or both 0, j >= 0; the next quadrant has those with i =
  // 0.
  const auto vertex = [](Index k, Index i, Index j) {
    if (i == 0 && j == 0) return Index{0};
    if (i == 0) return 1 + ((k + 1) % 5) * n * (n + 1) + (j - 1) * (n + 1);
    return 1 + k * n * (n + 1) + (i - 1) * (n + 1) + j;
  };
  for (Index k = 0; k < 5; ++k) {
    for (Index i = 1; i <= n; ++i) {
      for (Index j = 0; j <= n; ++j) {
        soup.positions.push_back(add(scale(i, axes[k]), scale(j, axes[(k + 1) % 5])));
      }
    }
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const Index a = vertex(k, i, j), b = vertex(k, i + 1, j), c = vertex(k, i + 1, j + 1),
                    d = vertex(k, i, j + 1);
        soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  const Mesh mesh(soup);
  // From 63 degrees on the upper side of one wall to 297 degrees on the plane: 233 of 450.
  const Index source = vertex(0, 1, 2), target = vertex(3, 2, 1);
  const double straight = 2 * std::sqrt(5);
  EXPECT_NEAR(solve("edge-based", mesh, source)[target], straight, 1e-14);
  const double found = solve("straight-graph", mesh, source)[target];
  EXPECT_GE(found, straight * (1 - 1e-15));
  EXPECT_LE(found, straight * (1 + kRounding));
}

// A notch of two by five squares in the upper side. The source has a fan of its own, so that only
// the second corner is left by a link that continues the path: by 243 of 270 degrees.
TEST(StraightGraph, is_exact_up_to_rounding_where_paths_bend_at_corners_of_the_boundary) {
  TriangleSoup soup = generate("grid", {{"columns", 8}, {"rows", 8}});
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    Vec3 middle{};
    for (const Index v : t) middle = add(middle, scale(1.0 / 3, soup.positions[v]));
    return middle[0] > 3 && middle[0] < 5 && middle[1] > 3;
  });
  const Mesh mesh(soup);
  const auto at = [](Index x, Index y) { return y * 9 + x; };
  const double bent = 2 + 2 * std::sqrt(5);
  EXPECT_NEAR(solve("edge-based", mesh, at(2, 5))[at(6, 5)], bent, 1e-14);
  const double found = solve("straight-graph", mesh, at(2, 5))[at(6, 5)];
  EXPECT_GE(found, bent * (1 - 1e-15));
  EXPECT_LE(found, bent * (1 + kRounding));
}

// Farther vertices on one line with a nearer one are reached over it.
TEST(StraightGraph, is_exact_at_the_vertices_that_a_source_sees_within_ten_edges) {
  const Mesh mesh(generate("grid", {{"columns", 40}, {"rows", 40}}));
  const Index source = mesh.vertex_count() / 2;
  const std::vector<double> distances = solve("straight-graph", mesh, source);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3 line = subtract(mesh.position(v), mesh.position(source));
    if (norm(line) > 10 || std::gcd(std::lround(line[0]), std::lround(line[1])) > 1) continue;
    EXPECT_NEAR(distances[v], norm(line), norm(line) * 1e-13) << v;
  }
}

// A path that crosses a flat lattice is too long by at most 1 / cos(alpha / 2) - 1.
TEST(StraightGraph, is_off_by_half_a_percent_at_most_in_the_plane) {
  TriangleSoup soup = generate("grid", {{"columns", 60}, {"rows", 50}});
  for (Vec3& p : soup.positions) p[0] += 0.3 * p[1];
  EXPECT_LT(largest_error(Mesh(soup), 1234), 1 / std::cos(0.1) - 1);
}

// A wedge that ends at the far edge of a face. Many sources have no finer fan.
TEST(StraightGraph, is_off_by_half_of_alpha_just_behind_the_edge_of_a_narrow_face) {
  for (const auto& [solver, alpha] :
       {std::pair{"straight-graph?alpha=0.2", 0.2}, {"straight-graph?alpha=0.02", 0.02}}) {
    const double half = std::tan(0.499 * alpha);
    const Mesh mesh(TriangleSoup{{{0, 0, 0}, {1, half, 0}, {1, -half, 0}, {1 + half * half, 0, 0}},
                                 {{0, 2, 1}, {2, 3, 1}}});
    const Query query{.sources = std::vector<Source>(100, {.at = Index{0}})};
    const double straight = 1 + half * half;
    EXPECT_NEAR(distances_by("edge-based", mesh, query)[3], straight, 1e-14);
    const double error = distances_by(solver, mesh, query)[3] / straight - 1;
    EXPECT_NEAR(error, alpha / 2, 0.05 * alpha);
  }
}

TEST(StraightGraph, is_off_by_two_percent_at_most_where_faces_have_no_area) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TriangleSoup terrain = rough_terrain(seed, 20, 20, 0.3);
    for (const TriangleSoup& soup :
         {with_flat_caps(terrain, seed, 3), with_collapsed_edges(terrain, seed, 10)}) {
      const Mesh mesh(soup);
      ASSERT_TRUE(mesh.has_degenerate_faces());
      EXPECT_LT(largest_error(mesh, 7), 0.02) << seed;
    }
  }
}

TEST(StraightGraph, is_off_by_less_than_one_percent_on_curved_surfaces) {
  for (const char* name : {"icosphere", "torus", "terrain"}) {
    EXPECT_LT(largest_error(Mesh(generate(name)), 0), 0.01) << name;
  }
}

// Buckets are as wide as a mean edge: the second source lies 10^15 of them ahead.
TEST(StraightGraph, ends_at_once_with_an_initial_distance_of_any_size) {
  TriangleSoup soup = generate("grid", {{"columns", 3}, {"rows", 3}});
  soup.positions.insert(soup.positions.end(), {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}});
  soup.triangles.push_back({16, 17, 18});
  const std::vector<double> distances =
      distances_by("straight-graph", Mesh(soup), {.sources = {{0}, {16, 1e15}}});
  EXPECT_EQ(distances[16], 1e15);
  EXPECT_NEAR(distances[17], 1e15 + 1, 1e15 * 1e-12);
}

TEST(StraightGraph, has_the_same_bits_with_any_number_of_threads) {
  const Mesh mesh(generate("terrain"));
  ASSERT_GT(mesh.vertex_count(), 2048U);
  const std::vector<double> one = solve("straight-graph", mesh, 5);
  for (const char* solver : {"straight-graph?threads=2", "straight-graph?threads=3"}) {
    const DelayedPieces delayed;
    EXPECT_EQ(solve(solver, mesh, 5), one) << solver;
  }
}

}  // namespace
}  // namespace geodesic
