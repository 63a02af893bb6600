// The plan of a run: its meshes, the facts about them, and its cells in order.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "harness/base/json.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/sources.h"
#include "harness/run/request.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

struct PlannedMesh {
  MeshEntry entry;
  Index vertices = 0;
  Json facts = {};                          ///< for context.geodesic_bench.meshes
  std::vector<SourceSet> sources = {};      ///< in a shard: those that it measures
  std::vector<SourceSet> run_sources = {};  ///< sources of the whole run
  std::vector<Index> further_sources = {};  ///< solved from one by one, after the first source
  /// Why a solver does not support this mesh, by its name without parameters.
  std::map<std::string, std::string, std::less<>> unsupported = {};

  /// Why a solver, named with or without parameters, does not support this mesh and source; null
  /// when it does.
  const std::string* unsupported_by(std::string_view solver, const SourceSet& source) const;
};

/// The measurements of one process.
struct Cell {
  const PlannedMesh* mesh;
  const SourceSet* source;
  const Description* solver;
  const Program* program = nullptr;  ///< null: this program
  int repetition = -1;               ///< the only one to measure, from 0; -1: all
  int repetitions = 1;               ///< number of repetitions, if it is one of several

  /// "<solver>/<mesh>/src:<source>"
  std::string name() const;
  bool is_first_repetition() const { return repetition <= 0; }
  /// Whether its source is the first one of its mesh in the whole run.
  bool is_of_first_source() const { return source->name == mesh->run_sources.front().name; }
  /// Why the solver does not support the mesh and source; null when it does.
  const std::string* unsupported() const;
};

struct SkippedMesh {
  std::string name;
  std::string why;
  bool unreadable = false;  ///< it was named and is there, but cannot be solved
};

struct Plan {
  std::vector<const Description*> solvers = {};
  std::vector<PlannedMesh> meshes = {};
  std::vector<SkippedMesh> skipped = {};
  std::vector<Program> programs = {};       ///< empty: this program only
  std::vector<std::string> only = {};       ///< names of the cells to measure; empty: all
  std::vector<ShardedMesh> whole_run = {};  ///< in a shard: the meshes of the whole run

  /// The cells by mesh, source and solver, in that order, so that drift of the machine affects all
  /// solvers of a mesh alike. The cells point into this plan.
  std::vector<Cell> cells() const { return interleaved_cells(-1); }

  /// The cells by mesh, source, repetition, solver and program, in that order. Odd repetitions have
  /// solvers and programs in the opposite order, so that none always comes first.
  /// @param repetitions -1: all repetitions of a cell in one process, as in `cells`
  std::vector<Cell> interleaved_cells(int repetitions) const;
};

/// The names of the sources, as in context.geodesic_bench.sources.
Json names_in_json(const std::vector<SourceSet>& sources);

/// One set, as in context.geodesic_bench.source_sets.
Json describe(const PlannedMesh& mesh, const SourceSet& source);

/// Whether solvers go on to the further sources of the mesh in this cell.
bool has_further_sources(const Cell& cell);

/// File for the further sources of a mesh, below the run folder, in the format of source_file.
std::filesystem::path further_sources_file(const PlannedMesh& mesh);

/// File for the vertices of a set, below the run folder, in the format of `solve --sources-file`.
std::filesystem::path source_file(const PlannedMesh& mesh, const SourceSet& source);

inline constexpr Index kLeastRecorded = 1000;    ///< vertices that a wavefront needs to be visible
inline constexpr Index kMostRecorded = 250'000;  ///< files grow with the mesh

/// Whether the cell writes recordings for figures.
bool leaves_recordings(const Cell& cell, Recordings choice);

/// The numbers of meshes, pairs of mesh and source, solvers and cells of the run, and of its shard
/// if it is one. No mesh is read: small meshes may have fewer sources than counted here.
/// @throws HarnessError as `make_plan`
Json outline(const RunRequest& request);

/// Reads every mesh of the suite and chooses its sources. Meshes of a corpus that are not in the
/// cache, and meshes that cannot be read, are skipped. Meshes and solvers that have none of
/// `request.cells` are left out.
/// @throws HarnessError for an unknown name, for a missing mesh that the suite itself names, for an
///         unknown cell, or when no mesh is left
Plan make_plan(const RunRequest& request);

/// context.geodesic_bench (results/README.md) of some cells of a run that starts now.
/// @param mesh,solver null: all meshes or solvers of the plan
Json run_context(const RunRequest& request, const Plan& plan, const PlannedMesh* mesh = nullptr,
                 const Description* solver = nullptr);

}  // namespace geodesic::harness
