// Nearly flat surfaces. In double precision, paths that bend by less than 1e-8 are as long as
// straight ones, so that either of two windows may be dropped. No vertex may be missed in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/random.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

TriangleSoup rough_grid(double height, double shift, std::uint64_t seed) {
  Random random(seed);
  TriangleSoup soup = generate("grid", {{"columns", 14}, {"rows", 14}, {"diagonal", "forward"}});
  for (auto& [x, y, z] : soup.positions) {
    x += random.between(0, shift);
    y += random.between(0, shift);
    z = random.between(0, height);
  }
  return soup;
}

// The largest amount by which the distances of an edge's ends differ by more than its length.
double worst_edge_violation(const Mesh& mesh, const std::vector<double>& distances) {
  double worst = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double difference = std::abs(distances[mesh.origin(h)] - distances[mesh.head(h)]);
    worst = std::max(worst, difference - mesh.half_edge(h).length);
  }
  return worst;
}

class NearlyFlat : public testing::TestWithParam<const char*> {};

TEST_P(NearlyFlat, NoVertexIsMissedBetweenWindows) {
  for (const double height : {0.0, 1e-7, 1e-5, 1e-4, 1e-3, 3e-3}) {
    for (const double shift : {0.0, 1e-9, 1e-8, 1e-7, 1e-5}) {
      const Mesh mesh(rough_grid(height, shift, 7));
      for (Index source = 3; source < mesh.vertex_count(); source += 17) {
        const auto distances = distances_by(GetParam(), mesh, {.sources = {{source}}});
        EXPECT_LT(worst_edge_violation(mesh, distances), 1e-12)
            << "height " << height << " shift " << shift << " source " << source;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ChenHan, NearlyFlat, testing::Values("ch", "ich", "fwp-ch"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace geodesic
