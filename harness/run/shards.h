// Division of a run into shards: the sources that a shard measures, and the meshes of the whole
// run, which identify the shards that belong together.
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

/// Reads "3/8". @throws HarnessError for another form, or when there is no such shard
Shard shard_named(const std::string& word);

/// A mesh of the whole run, as far as it is known without reading it.
struct ShardedMesh {
  std::string name;
  std::uintmax_t bytes = 0;  ///< of its file; 0 if the file is missing
  int sources = 1;           ///< number requested
};
GEODESIC_JSON_MEMBERS(ShardedMesh, name, bytes, sources)

/// For each mesh, in the given order, the places of the sources that the shard measures, from 0,
/// increasing. Each source of each mesh is in exactly one shard, with all solvers. Pairs of mesh
/// and source are assigned from the largest mesh to the smallest, each to the shard with the least
/// cost so far; a solve on an n-byte mesh costs n^(4/3). Only integers are used, so that all
/// machines get the same shards. (Graham 1969, Bounds on multiprocessing timing anomalies: the
/// largest shard is at most 4/3 of the least possible.)
/// @throws HarnessError when there are more shards than pairs
std::vector<std::vector<int>> sources_of_shard(std::span<const ShardedMesh> meshes, Shard shard);

}  // namespace geodesic::harness
