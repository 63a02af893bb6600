#include "harness/run/shards.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "harness/base/error.h"
#include "solvers/core/number_text.h"

namespace geodesic::harness {
namespace {

std::uint64_t cube_root(std::uint64_t n) {
  std::uint64_t root = 0;
  while ((root + 1) * (root + 1) * (root + 1) <= n) ++root;
  return root;
}

// Cost of a solve, up to a factor. At least 1, so that meshes of size 0 are assigned evenly.
std::uint64_t cost_of(const ShardedMesh& mesh) {
  return std::max<std::uint64_t>(mesh.bytes * cube_root(mesh.bytes), 1);
}

}  // namespace

Shard shard_named(const std::string& word) {
  const std::size_t slash = word.find('/');
  if (slash != std::string::npos) {
    const std::string_view text = word;
    const Shard shard{number_in<int>(text.substr(0, slash)).value_or(0),
                      number_in<int>(text.substr(slash + 1)).value_or(0)};
    if (shard.of <= kMostShards && shard.index >= 1 && shard.index <= shard.of) return shard;
  }
  throw HarnessError("--shard " + excerpt(word) + ": not K/N with K from 1 to N, N at most " +
                     std::to_string(kMostShards) + ", such as 3/8");
}

std::vector<std::vector<int>> sources_of_shard(std::span<const ShardedMesh> meshes, Shard shard) {
  std::vector<std::tuple<std::uint64_t, std::size_t, int>> pairs;  // cost, mesh, source
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::uint64_t cost = cost_of(meshes[i]);
    for (int source = 0; source < meshes[i].sources; ++source) pairs.emplace_back(cost, i, source);
  }
  if (std::cmp_greater(shard.of, pairs.size())) {
    throw HarnessError("--shard " + std::to_string(shard.index) + "/" + std::to_string(shard.of) +
                       ": the run has only " + std::to_string(pairs.size()) +
                       " pairs of mesh and source, and no shard can have less than one");
  }
  std::ranges::stable_sort(pairs, std::ranges::greater(),
                           [](const auto& pair) { return std::get<0>(pair); });
  using Load = std::pair<std::uint64_t, int>;  // cost of a shard so far, and its index
  std::priority_queue<Load, std::vector<Load>, std::greater<>> least;
  for (int index = 1; index <= shard.of; ++index) least.emplace(0, index);
  std::vector<std::vector<int>> ours(meshes.size());
  for (const auto& [cost, mesh, source] : pairs) {
    const auto [load, index] = least.top();
    least.pop();
    least.emplace(load + cost, index);
    if (index == shard.index) ours[mesh].push_back(source);
  }
  return ours;
}

}  // namespace geodesic::harness
