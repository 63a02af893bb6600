#include "harness/results/counters.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

Mesh square() {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
  return Mesh(corners, triangles);
}

TEST(Counters, AreAbsentWhereTheSolverHasNone) { EXPECT_EQ(counters_of({}, square()), Counters()); }

TEST(Counters, SpaceIsByTheWindowLimitWhereThereIsOne) {
  Recording recording;
  recording.peak_wavefront = 1000;
  EXPECT_DOUBLE_EQ(counters_of(recording, square()).space_thesis_mb.value(), 0.08);
  recording.window_limit = 5000;
  recording.window_bytes = 40;
  const Counters counters = counters_of(recording, square());
  EXPECT_DOUBLE_EQ(counters.space_thesis_mb.value(), 0.4);
  EXPECT_DOUBLE_EQ(counters.space_mb.value(), 0.2);
}

TEST(Counters, StripBIsTheRootOfTheVertexCount) {
  Recording recording;
  recording.strip_depth = 2;
  EXPECT_DOUBLE_EQ(counters_of(recording, square()).strip_b.value(), 2);
  recording.strip_depth = 0;
  EXPECT_FALSE(counters_of(recording, square()).strip_b);
}

TEST(Counters, AreNeverNonFinite) {
  Recording recording;
  recording.wavefront_sd = kInfinity;
  EXPECT_FALSE(counters_of(recording, square()).wavefront_sd);
}

TEST(Counters, SpreadOfTheWavefrontIsInEdgeLengthsToo) {
  Recording recording;
  recording.wavefront_sd = 3;
  const Mesh mesh = square();
  EXPECT_DOUBLE_EQ(counters_of(recording, mesh).wavefront_sd_edges.value(),
                   3 / mesh.mean_edge_length());
  EXPECT_NE(mesh.mean_edge_length(), 1);
}

TEST(Counters, AreAllVisited) {
  Recording recording;
  recording.window_propagations = recording.windows_created = recording.valid_windows =
      recording.reinsertions = recording.window_limit = recording.peak_wavefront =
          recording.strip_depth = recording.window_bytes = 1;
  recording.wavefront_sd = 1;
  const Counters all = counters_of(recording, square());
  Counters copy;
  for_each_counter(all, [&](const std::string& name, const auto& value) {
    EXPECT_TRUE(value) << name;
    for_each_counter(copy, [&](const std::string& other, auto& into) {
      if constexpr (std::is_same_v<decltype(into), std::remove_cvref_t<decltype(value)>&>) {
        if (name == other) into = value;
      }
    });
  });
  EXPECT_EQ(copy, all);
}

TEST(UnreachableVertices, AreTheInfiniteOnes) {
  EXPECT_EQ(unreachable_vertices(std::vector{0.0, kInfinity, 1.0, kInfinity}), 2u);
}

}  // namespace
}  // namespace geodesic::harness
