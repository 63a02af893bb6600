// Where one virtual source an edge is exact, and how far it is off elsewhere. What the solver
// promises besides, the conformance properties check.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshes/generators/generators.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

std::vector<double> solve(const char* solver, const Mesh& mesh, const std::vector<Index>& from) {
  Query query;
  for (const Index v : from) query.sources.push_back({v});
  std::vector<double> distances(mesh.vertex_count());
  make_solver(solver, mesh)->solve(query, distances);
  return distances;
}

/// Cells of the plane, each cut in two, without those that `is_hole(column, row)`.
template <class IsHole>
Mesh plane(Index columns, Index rows, const IsHole& is_hole) {
  TriangleSoup soup;
  for (Index row = 0; row <= rows; ++row) {
    // Sheared, so that no edge points at the source from afar.
    for (Index x = 0; x <= columns; ++x) soup.positions.push_back({x + 0.3 * row, 1.0 * row, 0});
  }
  for (Index row = 0; row < rows; ++row) {
    for (Index x = 0; x < columns; ++x) {
      if (is_hole(x, row)) continue;
      const Index a = row * (columns + 1) + x, b = a + columns + 1;
      soup.triangles.push_back({a, a + 1, b + 1});
      soup.triangles.push_back({a, b + 1, b});
    }
  }
  return Mesh(soup);
}

double distance_in_plane(const Mesh& mesh, Index a, Index b) {
  return std::hypot(mesh.position(a)[0] - mesh.position(b)[0],
                    mesh.position(a)[1] - mesh.position(b)[1]);
}

TEST(VirtualSource, is_exact_in_a_convex_piece_of_the_plane) {
  const Mesh mesh = plane(30, 20, [](Index, Index) { return false; });
  const Index source = 17;
  const std::vector<double> distances = solve("virtual-source", mesh, {source});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(distances[v], distance_in_plane(mesh, source, v), 1e-9) << v;
  }
}

TEST(VirtualSource, is_off_by_an_edge_at_most_where_waves_of_several_sources_meet) {
  const Mesh mesh = plane(30, 20, [](Index, Index) { return false; });
  const std::vector<Index> sources = {5, 29, 400};
  const std::vector<double> distances = solve("virtual-source", mesh, sources);
  Index off = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    double nearest = kInfinity;
    for (const Index s : sources) nearest = std::min(nearest, distance_in_plane(mesh, s, v));
    EXPECT_NEAR(distances[v], nearest, 1) << v;
    if (std::abs(distances[v] - nearest) > 1e-9) ++off;
  }
  EXPECT_LT(off, mesh.vertex_count() / 5);
}

TEST(VirtualSource, bends_round_the_corner_of_a_hole) {
  const auto is_hole = [](Index x, Index row) { return x >= 10 && row < 10; };
  const Mesh mesh = plane(20, 20, is_hole);
  const Index source = 9;  // beside the hole, so that what lies above it is seen over its corner
  const std::vector<double> exact = solve("edge-based", mesh, {source});
  const std::vector<double> distances = solve("virtual-source", mesh, {source});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (std::isinf(exact[v])) continue;
    EXPECT_NEAR(distances[v], exact[v], 0.02 * exact[v]) << v;
  }
}

TEST(VirtualSource, is_off_by_less_than_half_a_percent_in_the_mean_on_curved_surfaces) {
  for (const char* name : {"icosphere", "torus", "terrain"}) {
    const Mesh mesh(generate(name));
    const std::vector<double> exact = solve("edge-based", mesh, {0});
    const std::vector<double> distances = solve("virtual-source", mesh, {0});
    double sum = 0, largest = 0;
    for (Index v = 1; v < mesh.vertex_count(); ++v) {
      const double error = std::abs(distances[v] / exact[v] - 1);
      sum += error;
      largest = std::max(largest, error);
    }
    EXPECT_LT(sum / (mesh.vertex_count() - 1), 0.005) << name;
    EXPECT_LT(largest, 0.15) << name;
  }
}

}  // namespace
}  // namespace geodesic
