// Checks solvers on random meshes (meshes/oracles/random_case.h): distances from vertices and from
// points in faces and on edges, and paths.
#pragma once

#include <array>
#include <functional>
#include <map>

#include "harness/verify/isolated_check.h"
#include "meshes/oracles/random_case.h"

namespace geodesic::harness {

struct RandomMeshes {
  std::uint64_t count = 0, seed = 1;
  std::uint64_t first = 0;  ///< number of the first mesh
  unsigned jobs = 1;        ///< number of processes at a time
};

struct RandomFailure {
  std::uint64_t mesh;
  const Description* solver;
  const Property* property;
  CheckResult result;
};

struct RandomTally {
  struct OfSolver {
    std::uint64_t hold = 0, failed = 0;
    std::uint64_t not_known = 0;    ///< the reference refused or ended the process
    std::uint64_t not_checked = 0;  ///< the solver timed out too often before
    std::array<double, kMeshKinds> largest_error = {};  ///< of exact distances, by kind of mesh
  };
  std::array<std::uint64_t, kMeshKinds> meshes = {};
  std::map<std::string, OfSolver> solvers;
};

/// Checks all solvers on each mesh, in separate processes of a hundred meshes each. A crash or a
/// check that takes more than `time_limit` seconds is a failure; a new process continues after it.
/// @param vectors name of the instruction set to solve with (corpus/solvers.h)
/// @param failed called for every failure, by one thread at a time
/// @param tally counts of the checks made, also after an exception
/// @throws HarnessError, Interrupted
void check_on_random_meshes(const std::vector<const Description*>& solvers,
                            const RandomMeshes& meshes, const std::string& vectors,
                            double time_limit, const std::function<void(RandomFailure)>& failed,
                            RandomTally& tally);

}  // namespace geodesic::harness
