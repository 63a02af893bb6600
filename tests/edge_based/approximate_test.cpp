// The dial from exact to coarse. What every solver promises besides, the conformance properties
// check with the default tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

std::string with_tolerance(double tolerance) {
  return "edge-based-approximate?tolerance=" + ParameterValue(tolerance).text();
}

std::vector<double> distances(const std::string& solver, const Mesh& mesh, const Query& query,
                              Recording* recording = nullptr) {
  std::vector<double> distances(mesh.vertex_count());
  make_solver(solver, mesh)->solve(query, distances, recording);
  return distances;
}

TEST(EdgeBasedApproximate, gives_the_bits_of_edge_based_without_a_tolerance) {
  for (const auto& [name, soup] : random_meshes()) {
    const Mesh mesh(soup);
    const Query query{.sources = {{.at = 0}}};
    EXPECT_EQ(distances(with_tolerance(0), mesh, query), distances("edge-based", mesh, query))
        << name;
  }
}

TEST(EdgeBasedApproximate, is_off_by_no_more_than_any_tolerance) {
  std::vector<NamedMesh> meshes = random_meshes();
  meshes.push_back({"terrain", rough_terrain(1, 40, 40, 0.8)});
  meshes.push_back({"sphere", rough_sphere(2, 4, 0.1)});
  for (const auto& [name, soup] : meshes) {
    const Mesh mesh(soup);
    const Index last = mesh.vertex_count() - 1;
    for (const Query& query :
         {Query{.sources = {{.at = last / 2}}}, Query{.sources = {{.at = 0}, {last, 0.7}}}}) {
      const std::vector<double> exact = distances("edge-based", mesh, query);
      for (const double tolerance : {1.0, 0.3, 0.1, 0.01, 1e-3, 1e-4, 1e-6}) {
        const std::vector<double> d = distances(with_tolerance(tolerance), mesh, query);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
          if (exact[v] == kInfinity) {
            EXPECT_EQ(d[v], kInfinity);
          } else {
            EXPECT_LE(std::abs(d[v] - exact[v]), (tolerance + 1e-12) * exact[v])
                << name << ", vertex " << v << ", tolerance " << tolerance;
          }
        }
      }
    }
  }
}

TEST(EdgeBasedApproximate, propagates_few_windows) {
  const Mesh mesh(generate("terrain", {{"columns", 100}, {"rows", 100}}));
  const Query query{.sources = {{.at = 0}}};
  const auto windows = [&](const std::string& solver) {
    Recording recording;
    recording.kind = RecordingKind::counters;
    distances(solver, mesh, query, &recording);
    return *recording.window_propagations;
  };
  const auto exact = static_cast<double>(windows("edge-based"));
  const auto fine = static_cast<double>(windows(with_tolerance(1e-3)));
  const auto coarse = static_cast<double>(windows(with_tolerance(1e-2)));
  EXPECT_LT(fine, exact * 0.6);
  EXPECT_LT(coarse, exact * 0.4);
  EXPECT_EQ(static_cast<double>(windows(with_tolerance(0))), exact);
}

}  // namespace
}  // namespace geodesic
