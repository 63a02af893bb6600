#include "harness/results/counters.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

Mesh square() {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  return Mesh(corners, triangles);
}

TEST(Counters, AreAbsentWhereTheSolverHasNone) {
  EXPECT_EQ(counters({}, square()), Json::object());
}

TEST(Counters, SpaceIsByTheWindowLimitWhereThereIsOne) {
  Recording recording;
  recording.peak_wavefront = 1000;
  EXPECT_DOUBLE_EQ(counters(recording, square())["space_thesis_mb"].get<double>(), 0.08);
  recording.window_limit = 5000;
  recording.window_bytes = 40;
  const Json json = counters(recording, square());
  EXPECT_DOUBLE_EQ(json["space_thesis_mb"].get<double>(), 0.4);
  EXPECT_DOUBLE_EQ(json["space_mb"].get<double>(), 0.2);
}

TEST(Counters, StripBIsTheRootOfTheVertexCount) {
  Recording recording;
  recording.strip_depth = 2;
  EXPECT_DOUBLE_EQ(counters(recording, square())["strip_b"].get<double>(), 2);
  recording.strip_depth = 0;
  EXPECT_FALSE(counters(recording, square()).contains("strip_b"));
}

TEST(Counters, AreNeverNonFinite) {
  Recording recording;
  recording.wavefront_sd = kInfinity;
  EXPECT_FALSE(counters(recording, square()).contains("wavefront_sd"));
}

TEST(Counters, NamesListEveryKey) {
  Recording recording;
  recording.window_propagations = recording.windows_created = recording.valid_windows =
      recording.reinsertions = recording.window_limit = recording.peak_wavefront =
          recording.strip_depth = recording.window_bytes = 1;
  recording.wavefront_sd = 1;
  std::vector<std::string> keys;
  const Json all = counters(recording, square());
  for (const auto& [key, value] : all.items()) keys.push_back(key);
  EXPECT_EQ(keys, counter_names());
}

TEST(UnreachableVertices, AreTheInfiniteOnes) {
  EXPECT_EQ(unreachable_vertices(std::vector{0.0, kInfinity, 1.0, kInfinity}), 2u);
}

}  // namespace
}  // namespace geodesic::harness
