// A run before it runs: its meshes, what is known about them, and its cells in order.
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
  std::vector<SourceSet> sources = {};      ///< of a shard: those that it measures
  std::vector<SourceSet> run_sources = {};  ///< those of the whole run
  /// By solver, without parameters: why it cannot do this mesh.
  std::map<std::string, std::string, std::less<>> unsupported = {};

  /// Why a solver, which may have parameters, cannot do this mesh from this source; null when it
  /// can.
  const std::string* unsupported_by(std::string_view solver, const SourceSet& source) const;
};

/// Another build of geodesic-bench that is measured in place of this one.
struct MeasuredProgram {
  std::string name;
  std::filesystem::path file;
  Json facts = {};  ///< for context.geodesic_bench.programs
};

/// What one process measures.
struct Cell {
  const PlannedMesh* mesh;
  const SourceSet* source;
  const Description* solver;
  const MeasuredProgram* program = nullptr;  ///< null: this one
  int repetition = -1;                       ///< the only one, from 0; -1: all of them
  int repetitions = 1;                       ///< in all, where it is one of several

  /// "<solver>/<mesh>/src:<source>"
  std::string name() const;
  bool is_first_repetition() const { return repetition <= 0; }
  /// Why the solver cannot do the mesh from the source; null when it can.
  const std::string* unsupported() const;
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
  std::vector<MeasuredProgram> programs = {};  ///< empty: this one alone
  std::vector<std::string> only = {};          ///< names of cells; empty: all
  std::vector<ShardedMesh> whole_run = {};     ///< of a shard: the meshes that its run has

  /// For each mesh, source and solver: drift of the machine affects all solvers of a mesh alike.
  /// The cells point into this plan.
  std::vector<Cell> cells() const { return interleaved_cells(-1); }

  /// For each mesh and source, each repetition by itself: for each solver, for each program, and in
  /// the opposite order for odd repetitions, so that none always comes first.
  /// @param repetitions -1: all repetitions of a cell in one process, as `cells`
  std::vector<Cell> interleaved_cells(int repetitions) const;
};

/// As in context.geodesic_bench.sources.
Json names_in_json(const std::vector<SourceSet>& sources);

/// As in context.geodesic_bench.source_sets, of one set.
Json describe(const PlannedMesh& mesh, const SourceSet& source);

/// Below the run folder: the vertices of a set, as `solve --sources-file` takes them.
std::filesystem::path source_file(const PlannedMesh& mesh, const SourceSet& source);

inline constexpr Index kLeastRecorded = 1000;    ///< vertices: a wavefront needs some to show
inline constexpr Index kMostRecorded = 250'000;  ///< files grow with the mesh

/// Whether the cell leaves recordings for figures.
bool leaves_recordings(const Cell& cell, Recordings choice);

/// How many meshes, pairs of mesh and source, solvers and cells the run has, and its shard if it is
/// one, as far as that is known without reading a mesh: small ones have fewer sources.
/// @throws HarnessError as `make_plan`
Json outline(const RunRequest& request);

/// Reads every mesh of the suite and chooses its sources. Meshes of a corpus that are not in the
/// cache, and meshes that cannot be read, are skipped. Meshes and solvers that have none of
/// `request.cells` are left out.
/// @throws HarnessError for an unknown name, for a mesh that the suite names itself and that is not
///         there, for an unknown cell, or when no mesh is left
Plan make_plan(const RunRequest& request);

/// context.geodesic_bench (results/README.md) of some cells of a run, which starts now.
/// @param mesh,solver null: all of the plan
Json run_context(const RunRequest& request, const Plan& plan, const PlannedMesh* mesh = nullptr,
                 const Description* solver = nullptr);

}  // namespace geodesic::harness
