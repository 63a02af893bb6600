// The effect of the tolerance. The conformance properties check the other promises of solvers, with
// the default tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

std::string with_tolerance(double tolerance) {
  return "edge-based-approximate?tolerance=" + ParameterValue(tolerance).text();
}

TEST(EdgeBasedApproximate, gives_the_bits_of_edge_based_without_a_tolerance) {
  for (const auto& [name, soup] : random_meshes()) {
    const Mesh mesh(soup);
    const Query query{.sources = {{.at = 0}}};
    EXPECT_EQ(distances_by(with_tolerance(0), mesh, query), distances_by("edge-based", mesh, query))
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
      const std::vector<double> exact = distances_by("edge-based", mesh, query);
      for (const double tolerance : {1.0, 0.3, 0.1, 0.01, 1e-3, 1e-4, 1e-6}) {
        const std::vector<double> d = distances_by(with_tolerance(tolerance), mesh, query);
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
    return static_cast<double>(propagated_by(solver, mesh, query));
  };
  const double exact = windows("edge-based");
  EXPECT_LT(windows(with_tolerance(1e-3)), exact * 0.6);
  EXPECT_LT(windows(with_tolerance(1e-2)), exact * 0.4);
  EXPECT_EQ(windows(with_tolerance(0)), exact);
}

}  // namespace
}  // namespace geodesic
