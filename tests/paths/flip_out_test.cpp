// Paths that edge flips make from Dijkstra's paths.
#include <gtest/gtest.h>

#include "harness/verify/path_check.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

/// Tolerance for paths whose angles may be 1e-8 less than pi.
constexpr harness::Tolerance kStraight{.relative = 1e-7};

/// The paths of a solver from one vertex to all others.
std::vector<Path> paths_of(const std::string& solver, const Mesh& mesh, Index source) {
  const Query query{.sources = {{.at = source}}};
  std::vector<double> distances(mesh.vertex_count());
  const auto object = make_solver(solver, mesh);
  object->solve(query, distances);
  std::vector<Path> paths;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (distances[v] < kInfinity) paths.push_back(object->trace(query, distances, v));
  }
  return paths;
}

TEST(FlipOut, makes_paths_straight_and_never_longer_than_those_along_edges) {
  int shorter = 0;
  for (const auto& [name, soup] : random_meshes()) {
    SCOPED_TRACE(name);
    const Mesh mesh(soup);
    if (mesh.has_degenerate_faces()) continue;
    const std::vector<Path> along_edges = paths_of("dijkstra", mesh, 0);
    const std::vector<Path> flipped = paths_of("flip-out", mesh, 0);
    ASSERT_EQ(flipped.size(), along_edges.size());
    for (std::size_t i = 0; i < flipped.size(); ++i) {
      const auto finding = harness::check_straight(mesh, flipped[i], kStraight);
      EXPECT_EQ(finding ? finding->what : "", "") << i;
      EXPECT_LE(flipped[i].length(), along_edges[i].length() * (1 + 1e-14)) << i;
      shorter += flipped[i].length() < 0.99 * along_edges[i].length() ? 1 : 0;
    }
  }
  EXPECT_GT(shorter, 100);
}

TEST(FlipOut, finds_the_straight_line_of_a_plane_however_edges_run) {
  for (const char* diagonal : {"forward", "alternating"}) {
    const Mesh mesh(generate("grid", {{"columns", 12}, {"rows", 9}, {"diagonal", diagonal}}),
                    Numbering::along_surface);
    for (const Path& path : paths_of("flip-out", mesh, 0)) {
      const Vec3 line = subtract(path.points.back().position, path.points.front().position);
      EXPECT_NEAR(path.length(), norm(line), 1e-13);
    }
  }
}

TEST(FlipOut, finds_the_shortest_path_often_and_a_longer_one_as_often) {
  const Mesh mesh(rough_sphere(6, 4, 0.1));
  const std::vector<double> exact = distances_by("edge-based", mesh, {.sources = {{.at = 0}}});
  int shortest = 0;
  const std::vector<Path> paths = paths_of("flip-out", mesh, 0);
  for (const Path& path : paths) {
    const double expected = exact[path.points.back().at.vertex];
    EXPECT_GE(path.length(), expected * (1 - 1e-12));
    shortest += path.length() <= expected * (1 + 1e-9) ? 1 : 0;
  }
  const int all = static_cast<int>(paths.size());
  EXPECT_GT(shortest, all / 10);
  EXPECT_LT(shortest, all * 9 / 10);
}

}  // namespace
}  // namespace geodesic
