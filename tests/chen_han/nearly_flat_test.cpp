// Nearly flat surfaces: paths that bend by less than 1e-8 are as long as straight ones in double
// precision, so that it is chance which of two windows is dropped. No vertex may get lost between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic {
namespace {

constexpr int kSide = 14;  // cells

TriangleSoup rough_grid(double height, double shift, unsigned seed) {
  std::mt19937 random(seed);
  const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0; };
  TriangleSoup soup;
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) {
      soup.positions.push_back({i + shift * noise(), j + shift * noise(), height * noise()});
    }
  }
  const auto at = [](int i, int j) { return static_cast<Index>(i * (kSide + 1) + j); };
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

// How much more than the length of an edge the distances of its ends differ.
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
      const auto solver = make_solver(GetParam(), mesh);
      std::vector<double> distances(mesh.vertex_count());
      for (Index source = 3; source < mesh.vertex_count(); source += 17) {
        solver->solve({{{source, 0}}}, distances);
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
