// A run before it runs: its meshes, what is known about them, and its cells in order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/suite.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

struct PlannedMesh {
  MeshEntry entry;
  Index vertices = 0;
  Json facts = {};  ///< for context.geodesic_bench.meshes
  std::vector<Index> sources = {};
  std::map<std::string, std::string> unsupported = {};  ///< by solver: why it cannot do this mesh
};

struct Cell {
  const PlannedMesh* mesh;
  Index source;
  const Description* solver;
};

struct SkippedMesh {
  std::string name;
  std::string why;
  bool unreadable = false;  ///< it is there, but not a mesh that can be solved
};

struct Plan {
  std::vector<const Description*> solvers = {};
  std::vector<PlannedMesh> meshes = {};
  std::vector<SkippedMesh> skipped = {};

  /// For each mesh, for each source, for each solver: a drift of the machine hits all solvers of a
  /// mesh alike. The cells point into this plan.
  std::vector<Cell> cells() const;
};

/// Reads every mesh of the suite and chooses its sources. Meshes of a corpus that are not in the
/// cache, and meshes that cannot be read, are skipped.
/// @throws HarnessError for an unknown name, for a mesh that the suite names itself and that is not
///         there, or when no mesh is left
Plan make_plan(const Suite& suite, const std::filesystem::path& manifest);

}  // namespace geodesic::harness
