// The processes that a run starts, `geodesic-bench cell SPEC` and `geodesic-bench reference SPEC`.
// SPEC is JSON. A cell is one solver on one mesh from one source.
//
// A run may measure older builds (run --program), so SPEC is an interface between revisions:
// members keep their names and meanings, and new ones are optional, with the old behaviour as
// default.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/base/process.h"
#include "harness/corpus/outcome.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

struct CellSpec {
  std::string solver;
  std::string mesh;                 ///< name
  std::string mesh_file;            ///< path
  Index source = 0;                 ///< vertex
  std::string source_set = {};      ///< name of a set that replaces `source`
  std::string sources_file = {};    ///< file with the vertices of the set
  std::string reference = {};       ///< the solver that the distances are compared with
  std::string reference_file = {};  ///< file with its distances (verify/references.h)
  std::string output = {};          ///< the file to write: {"benchmarks": rows}
  std::string run_folder = {};
  bool with_counters = true;     ///< make more solves, for counters, memory and phases
  bool with_recordings = false;  ///< write recordings to the run folder; only with counters
  bool frames = false;           ///< record the wavefront at every step; only with recordings
  int other_queries = 0;  ///< number of solves from other vertices, before another from the source
  int path_targets = 0;   ///< targets to measure paths to, with counters, of solvers with paths
  std::string further_sources = {};    ///< file with vertices to solve from, one after the other
  std::string further_reference = {};  ///< the exact solver of their distances; empty: none
  std::string further_reference_file = {};  ///< file with their distances
  std::string vectors;                      ///< name of the instruction set (corpus/solvers.h)
  std::vector<std::string> benchmark_flags = {};
  bool repair = false;  ///< repair the mesh first
};
GEODESIC_JSON_MEMBERS(CellSpec, solver, mesh, mesh_file, source, source_set, sources_file,
                      reference, reference_file, output, run_folder, with_counters, with_recordings,
                      frames, other_queries, path_targets, further_sources, further_reference,
                      further_reference_file, vectors, benchmark_flags, repair)

/// A solve whose distances verify other solvers.
struct ReferenceSpec {
  std::string solver;
  std::string mesh_file;
  Index source = 0;               ///< vertex
  std::string sources_file = {};  ///< file with several vertices that replace `source`
  bool each = false;              ///< solve from each of them, in this order, not from all at once
  std::string output;             ///< distance file to write
  bool repair = false;            ///< repair the mesh first
};
GEODESIC_JSON_MEMBERS(ReferenceSpec, solver, mesh_file, source, sources_file, each, output, repair)

/// Prepares the solver, verifies a warm-up solve, solves from other sources and again from this
/// one, times solves and, with_counters, records more with new solver objects. Then it writes the
/// recordings, if wanted, and the rows. If distances are wrong or differ between these
/// solves, the only row has the error and no time.
/// @throws the exceptions of mesh reader, solver and disk; the run writes an error row for them
void run_cell(const CellSpec& spec);

/// Solves, once or from each source, and writes the distances. @throws as run_cell
void run_reference(const ReferenceSpec& spec);

/// Does the work of such a process. Turns an exception into a line on standard error and an exit
/// code for failure_of.
int exit_code_of(const std::function<void()>& work);

struct Failure {
  Outcome outcome;
  std::string why;
};

/// Why such a process failed.
/// @param limits of the process
/// @throws CannotWrite when the process could not write: later cells could not write either
Failure failure_of(const Ended& ended, const ProcessLimits& limits);

}  // namespace geodesic::harness
