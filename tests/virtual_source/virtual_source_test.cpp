// How far the distances of one virtual source an edge are off. What the solver promises besides,
// the conformance properties check.
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

/// A sheared piece of the plane.
Mesh plane() {
  TriangleSoup soup = generate("grid", {{"columns", 30}, {"rows", 20}});
  for (Vec3& p : soup.positions) p[0] += 0.3 * p[1];
  return Mesh(soup);
}

double distance_in_plane(const Mesh& mesh, Index a, Index b) {
  return std::hypot(mesh.position(a)[0] - mesh.position(b)[0],
                    mesh.position(a)[1] - mesh.position(b)[1]);
}

TEST(VirtualSource, is_off_by_less_than_two_percent_in_a_convex_piece_of_the_plane) {
  const Mesh mesh = plane();
  const Index source = 17;
  const std::vector<double> distances = solve("virtual-source", mesh, {source});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double straight = distance_in_plane(mesh, source, v);
    EXPECT_NEAR(distances[v], straight, 0.02 * straight) << v;
  }
}

TEST(VirtualSource, is_nowhere_too_long_within_five_edges_of_a_source_in_the_plane) {
  const Mesh mesh = plane();
  for (const Index source : {Index{17}, Index{250}}) {
    const std::vector<double> distances = solve("virtual-source", mesh, {source});
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double straight = distance_in_plane(mesh, source, v);
      if (straight > 5 * mesh.mean_edge_length()) continue;
      EXPECT_LE(distances[v], straight * (1 + 1e-12)) << v;
    }
  }
}

TEST(VirtualSource, is_off_by_an_edge_at_most_where_waves_of_several_sources_meet) {
  const Mesh mesh = plane();
  const std::vector<Index> sources = {5, 29, 400};
  const std::vector<double> distances = solve("virtual-source", mesh, sources);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    double nearest = kInfinity;
    for (const Index s : sources) nearest = std::min(nearest, distance_in_plane(mesh, s, v));
    EXPECT_NEAR(distances[v], nearest, 1) << v;
  }
}

// Where waves of two sources meet, the circles round both say nothing of either.
TEST(VirtualSource, is_off_by_less_than_half_a_percent_in_the_mean_from_a_hundred_sources) {
  const Mesh mesh(generate("terrain"));
  std::vector<Index> sources;
  for (Index v = 0; v < mesh.vertex_count(); v += mesh.vertex_count() / 100) sources.push_back(v);
  const std::vector<double> exact = solve("edge-based", mesh, sources);
  const std::vector<double> distances = solve("virtual-source", mesh, sources);
  double sum = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (exact[v] > 0) sum += std::abs(distances[v] / exact[v] - 1);
  }
  EXPECT_LT(sum / mesh.vertex_count(), 0.005);
}

TEST(VirtualSource, bends_round_the_corners_of_a_hole) {
  const Mesh mesh(generate("square-with-hole"));
  const Index source = 7;
  const std::vector<double> exact = solve("edge-based", mesh, {source});
  const std::vector<double> distances = solve("virtual-source", mesh, {source});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
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
