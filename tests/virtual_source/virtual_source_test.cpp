// Errors of the distances with one virtual source per edge. The conformance properties check the
// other promises of the solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshes/generators/generators.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

std::vector<double> solve(const char* solver, const Mesh& mesh, const std::vector<Index>& from) {
  Query query;
  for (const Index v : from) query.sources.push_back({v});
  return distances_by(solver, mesh, query);
}

/// Relative errors against exact distances.
struct Errors {
  double mean = 0, largest = 0;
};
Errors errors_on(const Mesh& mesh, const std::vector<Index>& sources) {
  const std::vector<double> exact = solve("edge-based", mesh, sources);
  const std::vector<double> distances = solve("virtual-source", mesh, sources);
  Errors errors;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (exact[v] == 0) continue;
    const double error = std::abs(distances[v] / exact[v] - 1);
    errors.mean += error / mesh.vertex_count();
    errors.largest = std::max(errors.largest, error);
  }
  return errors;
}

/// A sheared, convex piece of the plane.
Mesh plane() {
  TriangleSoup soup = generate("grid", {{"columns", 30}, {"rows", 20}});
  for (Vec3& p : soup.positions) p[0] += 0.3 * p[1];
  return Mesh(soup);
}

double distance_in_plane(const Mesh& mesh, Index a, Index b) {
  return std::hypot(mesh.position(a)[0] - mesh.position(b)[0],
                    mesh.position(a)[1] - mesh.position(b)[1]);
}

TEST(VirtualSource, is_off_by_less_than_two_percent_in_the_plane_and_round_the_corners_of_a_hole) {
  EXPECT_LT(errors_on(plane(), {17}).largest, 0.02);
  EXPECT_LT(errors_on(Mesh(generate("square-with-hole")), {7}).largest, 0.02);
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

// Where waves of two sources meet, the ends of an edge have no common virtual source.
TEST(VirtualSource, is_off_by_less_than_half_a_percent_in_the_mean_from_a_hundred_sources) {
  const Mesh mesh(generate("terrain"));
  std::vector<Index> sources;
  for (Index v = 0; v < mesh.vertex_count(); v += mesh.vertex_count() / 100) sources.push_back(v);
  EXPECT_LT(errors_on(mesh, sources).mean, 0.005);
}

TEST(VirtualSource, is_off_by_less_than_half_a_percent_in_the_mean_on_curved_surfaces) {
  for (const char* name : {"icosphere", "torus", "terrain"}) {
    const Errors errors = errors_on(Mesh(generate(name)), {0});
    EXPECT_LT(errors.mean, 0.005) << name;
    EXPECT_LT(errors.largest, 0.15) << name;
  }
}

}  // namespace
}  // namespace geodesic
