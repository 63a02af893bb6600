// A run in parts: which sources of which meshes a shard measures, and by what shards of one run are
// known to belong together.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "harness/base/json.h"

namespace geodesic::harness {

/// Part `index`, from 1, of a run in `of` parts.
struct Shard {
  int index = 1;
  int of = 1;
};
GEODESIC_JSON_MEMBERS(Shard, index, of)

inline constexpr int kMostShards = 100'000;

/// "3/8". @throws HarnessError for anything else, and for a part that there is not
Shard shard_named(const std::string& word);

/// A mesh of the whole run, as far as it is known without reading it.
struct ShardedMesh {
  std::string name;
  std::uintmax_t bytes = 0;  ///< of its file; 0 where that is not there
  int sources = 1;           ///< asked for
};
GEODESIC_JSON_MEMBERS(ShardedMesh, name, bytes, sources)

/// For each mesh, in their order, which of its sources (their places, from 0, rising) the shard
/// measures. Each source of each mesh is in exactly one shard, with all solvers. The pairs of mesh
/// and source are dealt out from the largest mesh to the smallest, each to the shard with the least
/// so far; a solve of an n-byte mesh counts as n^(4/3). Integers alone decide, so that every
/// machine deals alike. (Graham 1969, Bounds on multiprocessing timing anomalies: the largest shard
/// is at most 4/3 of the least possible.)
/// @throws HarnessError when there are more shards than pairs
std::vector<std::vector<int>> sources_of_shard(std::span<const ShardedMesh> meshes, Shard shard);

}  // namespace geodesic::harness
