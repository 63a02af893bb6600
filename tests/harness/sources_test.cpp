#include "harness/corpus/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "meshes/random.h"

namespace geodesic::harness {
namespace {

// A fan of n - 2 triangles around its first vertex; the vertices before it have no face.
TriangleSoup fan(Index isolated, Index n) {
  TriangleSoup soup;
  soup.positions.resize(isolated + n);
  for (Index v = 1; v + 1 < n; ++v) {
    soup.triangles.push_back({isolated, isolated + v, isolated + v + 1});
  }
  return soup;
}

TEST(SplitMix, GivesThePublishedSequence) {
  EXPECT_EQ(split_mix(1234567), 6457827717110365317u);
  EXPECT_EQ(split_mix(1234567 + 0x9e3779b97f4a7c15u), 3203168211198807973u);
}

TEST(Sources, AreTheSameForTheSameSeed) {
  EXPECT_EQ(choose_sources(fan(0, 100), "m", 5, 1), choose_sources(fan(0, 100), "m", 5, 1));
  EXPECT_NE(choose_sources(fan(0, 100), "m", 5, 1), choose_sources(fan(0, 100), "m", 5, 2));
  EXPECT_NE(choose_sources(fan(0, 100), "m", 5, 1), choose_sources(fan(0, 100), "n", 5, 1));
}

TEST(Sources, StartWithVertexZero) {
  EXPECT_EQ(choose_sources(fan(0, 100), "m", 1, 1), std::vector<Index>{0});
}

TEST(Sources, HaveABoundaryVertexSecond) {
  // A disc: vertex 0 and vertex 1 inside, a ring of 60 around them.
  TriangleSoup soup;
  soup.positions.resize(62);
  for (Index v = 2; v < 62; ++v)
    soup.triangles.push_back({v < 32 ? 0u : 1u, v, v == 61 ? 2 : v + 1});
  soup.triangles.push_back({0, 32, 1});
  soup.triangles.push_back({0, 1, 2});
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Index> sources = choose_sources(soup, "m", 3, seed);
    EXPECT_EQ(sources[0], 0u);
    EXPECT_GE(sources[1], 2u) << "with seed " << seed;
  }
}

TEST(Sources, AreNeverIsolated) {
  const std::vector<Index> sources = choose_sources(fan(50, 10), "m", 10, 1);
  EXPECT_EQ(sources.size(), 10u);
  for (const Index v : sources) EXPECT_GE(v, 50u);
}

TEST(Sources, AreDistinctAndAtMostAllVertices) {
  const std::vector<Index> sources = choose_sources(fan(0, 20), "m", 50, 3);
  EXPECT_EQ(std::set<Index>(sources.begin(), sources.end()).size(), 20u);
  EXPECT_EQ(sources.size(), 20u);
}

TEST(Sources, FewerAreAPrefixOfMore) {
  const std::vector<Index> few = choose_sources(fan(0, 100), "m", 3, 1);
  const std::vector<Index> many = choose_sources(fan(0, 100), "m", 9, 1);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

}  // namespace
}  // namespace geodesic::harness
