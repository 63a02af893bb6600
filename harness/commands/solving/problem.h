// The flags of `solve`, and the problem that they describe.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/points.h"
#include "harness/corpus/solvers.h"
#include "meshes/load.h"
#include "meshes/pair_distances.h"

namespace geodesic::harness {

struct SolveFlags {
  std::vector<std::string> meshes;
  std::string solver = "edge-based";  // the fastest exact one
  std::vector<std::string> sources, targets;
  std::string sources_file, targets_file, pairs_file, sets_file, output, output_folder, paths,
      isolines, levels;
  std::string prepared, save_prepared;
  bool repair = false, cross_non_manifold = false, each = false, check = false, counters = false;
  bool stop_at_targets = false, nearest_source = false, angles = false;
  std::optional<double> weld;
  AvoidedFiles avoid;
  unsigned threads = 1;
  double limit = kInfinity;
  std::string vectors = kAutoVectors;
  std::string manifest = default_manifest().string();
};

/// Whether several queries are solved, each for a row of distances.
bool wants_rows(const SolveFlags& flags);

/// Whether paths are to be traced.
bool wants_paths(const SolveFlags& flags);

/// Checks that the flags go together, before anything is read. @throws HarnessError
void check_combination(const SolveFlags& flags);

/// The levels of isolines: some number of them, equal steps apart, or distances.
struct Levels {
  Index count = 0;
  std::vector<double> given;  ///< if count is 0
};

/// The points, levels and avoided elements that the flags name, before a mesh is read. @throws
/// HarnessError
struct WrittenValues {
  explicit WrittenValues(const SolveFlags& flags);
  std::vector<WrittenPoint> sources, targets;
  std::vector<WrittenPair> pairs;
  std::vector<WrittenSet> sets;
  Levels levels;
  Avoided avoided;
};

/// The problem, read and checked.
struct Problem {
  const SolveFlags& flags;
  const Description& solver;  ///< has the number of threads for one source
  unsigned threads;           ///< number of threads for different sources
  const MeshEntry& entry;
  const TriangleSoup& soup;
  const Mesh& mesh;
  Query query;                                 ///< without sources if there are pairs or rows
  std::vector<std::vector<Source>> rows = {};  ///< of --each one source each, or those of --sets
  std::vector<PointPair> pairs = {};           ///< of --pairs
  std::optional<GroupedPairs> grouped = {};    ///< the pairs, if there are any
  Levels levels = {};
  Json places = Json::array();  ///< for points that are given as places in space
  std::shared_ptr<const InsertedPoints> inserted = {};  ///< as in PointSolver
};

/// @param built from the entry's file. All arguments except `values` must outlive the problem
/// @throws HarnessError for points that the mesh does not have, and for requests beyond the
///         solver's abilities
Problem read_problem(const SolveFlags& flags, const Description& solver, const MeshEntry& entry,
                     const BuiltMesh& built, const WrittenValues& values);

}  // namespace geodesic::harness
