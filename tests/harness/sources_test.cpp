#include "harness/corpus/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/base/files.h"
#include "meshes/generators/generators.h"
#include "meshes/random.h"
#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

// A fan of n - 2 triangles around its first vertex, after `isolated` vertices without faces.
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
  // A disc: vertices 0 and 1 are inside, a ring of 60 vertices is around them.
  TriangleSoup soup;
  soup.positions.resize(62);
  for (Index v = 2; v < 62; ++v) {
    soup.triangles.push_back({v < 32 ? 0u : 1u, v, v == 61 ? 2 : v + 1});
  }
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

// Two triangles of vertices 2 to 7 without a common vertex. Vertices 0 and 1 have no face.
TriangleSoup two_components() {
  TriangleSoup soup;
  soup.positions.resize(8);
  soup.triangles = {{5, 6, 7}, {2, 3, 4}};
  return soup;
}

std::vector<Index> vertices_of(const std::string& set, const TriangleSoup& soup) {
  const auto found = find_source_set(set, soup, "m", 1);
  return found ? found->vertices : std::vector<Index>{};
}

TEST(SourceSets, AreRandomVerticesTheBoundaryOrOneOfEachComponent) {
  EXPECT_EQ(vertices_of("random:9", fan(0, 100)), choose_sources(fan(0, 100), "m", 9, 1));
  EXPECT_EQ(vertices_of("random:9", two_components()).size(), 6u) << "all that there are";
  EXPECT_EQ(vertices_of("boundary", two_components()), (std::vector<Index>{2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(vertices_of("components", two_components()), (std::vector<Index>{2, 5}));
  TriangleSoup closed;
  closed.positions.resize(4);
  closed.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  EXPECT_FALSE(find_source_set("boundary", closed, "m", 1)) << "it has none";
}

TEST(SourceSets, OfAFileAreCalledLikeItAndHaveVerticesOfTheMesh) {
  const std::filesystem::path folder = ::testing::TempDir();
  const std::string file = folder / "front-row.json", other = folder / "points.txt";
  write_source_vertices(file, {2, 4, 7});
  const auto set = find_source_set(file, two_components(), "m", 1);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->name, "front-row");
  EXPECT_EQ(set->vertices, (std::vector<Index>{2, 4, 7}));
  EXPECT_FALSE(set->is_single());
  TriangleSoup small = two_components();
  small.positions.resize(7);
  expect_error([&] { find_source_set(file, small, "m", 1); }, {"front-row", "vertex 7", "has 7"});
  write_bytes(other, "1, edge:3-4:0.5");
  expect_error([&] { find_source_set(other, two_components(), "m", 1); },
               {"points.txt", "edge:3-4:0.5", "vertices only"});
  const std::string number = folder / "12.json";
  write_source_vertices(number, {1});
  expect_error([&] { name_of_source_set(number); }, {"12.json", "name of a vertex"});
}

TEST(SourceSets, OfNoFormAreRefusedWithTheForms) {
  for (const char* word : {"random", "random:", "random:0", "random:-1", "random:x", "edge", "8"}) {
    expect_error([&] { name_of_source_set(word); }, {word, "random:N", "boundary", "components"});
  }
}

TEST(SpreadVertices, AreEqualStepsAlongTheSurfaceFromTheFirst) {
  const Mesh mesh(generate("terrain", {{"columns", 9}, {"rows", 9}}), Numbering::along_surface);
  ASSERT_FALSE(mesh.numbers().is_identity());
  std::vector<double> distances(100, 1);
  const Index unreached = mesh.numbers().external_vertex(99);
  distances[unreached] = kInfinity;
  const std::vector<Index> spread = spread_vertices(mesh, 50, 9, distances);
  ASSERT_EQ(spread.size(), 9u);
  EXPECT_EQ(spread[0], 50u);
  for (std::size_t i = 0; i < spread.size(); ++i) {
    const Index own = mesh.numbers().internal_vertex(50) + static_cast<Index>(11 * i);
    EXPECT_EQ(spread[i], mesh.numbers().external_vertex(own % 99));
  }
}

}  // namespace
}  // namespace geodesic::harness
