#include "harness/run/shards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "expect_error.h"

namespace geodesic::harness {
namespace {

// Meshes whose sizes differ by a factor of a million, as in a real corpus.
std::vector<ShardedMesh> corpus() {
  std::vector<ShardedMesh> meshes;
  for (unsigned i = 0; i < 40; ++i) {
    meshes.push_back({.name = "mesh" + std::to_string(i),
                      .bytes = std::uintmax_t{100} << (i * 7 % 20),
                      .sources = 1 + static_cast<int>(i % 4)});
  }
  return meshes;
}

TEST(Shards, HoldEverySourceOfEveryMeshExactlyOnce) {
  const std::vector<ShardedMesh> meshes = corpus();
  for (const int of : {1, 2, 7, 100}) {
    std::vector<std::set<int>> seen(meshes.size());
    for (int index = 1; index <= of; ++index) {
      const auto ours = sources_of_shard(meshes, {index, of});
      std::size_t pairs = 0;
      for (std::size_t i = 0; i < meshes.size(); ++i) {
        EXPECT_TRUE(std::ranges::is_sorted(ours[i]));
        for (const int source : ours[i]) EXPECT_TRUE(seen[i].insert(source).second);
        pairs += ours[i].size();
      }
      EXPECT_GE(pairs, 1u) << index << " of " << of;
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      EXPECT_EQ(seen[i].size(), static_cast<std::size_t>(meshes[i].sources));
    }
  }
}

// Graham's bound for greedy list scheduling: the mean load plus one job.
TEST(Shards, AreAsLargeAsTheMeanButForOneSource) {
  const std::vector<ShardedMesh> meshes = corpus();
  const auto cost = [](const ShardedMesh& mesh) {
    return std::pow(static_cast<double>(mesh.bytes), 4.0 / 3);
  };
  double all = 0, largest = 0;
  for (const ShardedMesh& mesh : meshes) {
    all += mesh.sources * cost(mesh);
    largest = std::max(largest, cost(mesh));
  }
  for (int index = 1; index <= 8; ++index) {
    const auto ours = sources_of_shard(meshes, {index, 8});
    double load = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      load += static_cast<double>(ours[i].size()) * cost(meshes[i]);
    }
    EXPECT_LE(load, 1.05 * (all / 8 + largest)) << index;  // roots are rounded down
  }
}

TEST(Shards, AreNotMoreThanPairsOfMeshAndSource) {
  const std::vector<ShardedMesh> meshes{{"a", 100, 2}, {"b", 0, 1}};
  EXPECT_NO_THROW(sources_of_shard(meshes, {3, 3}));
  expect_error([&] { sources_of_shard(meshes, {4, 4}); }, {"--shard 4/4", "only 3 pairs"});
}

TEST(Shards, AreNamedByNumberAndCount) {
  EXPECT_EQ(shard_named("3/8").index, 3);
  EXPECT_EQ(shard_named("3/8").of, 8);
  for (const char* word : {"", "3", "0/8", "9/8", "3/8x", "x3/8", "-1/8", "3/", "/8", "1/100001",
                           "1/99999999999", "1/2/3"}) {
    expect_error([&] { shard_named(word); }, {"not K/N"});
  }
}

}  // namespace
}  // namespace geodesic::harness
