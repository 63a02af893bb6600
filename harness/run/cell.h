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
  std::string source_set = {};      ///< in place of it: the name of a set
  std::string sources_file = {};    ///< with its vertices
  std::string reference = {};       ///< the solver that the distances are compared with
  std::string reference_file = {};  ///< its distances (verify/references.h)
  std::string output = {};          ///< the file to write: {"benchmarks": rows}
  std::string run_folder = {};
  bool counted = true;    ///< solve some more, for counters, memory and phases
  bool pictured = false;  ///< leave recordings in the run folder; only of counted cells
  bool frames = false;    ///< a pictured cell: the wavefront at every step of progress
  int other_queries = 0;  ///< solve from so many other vertices, then from the source again
  int path_targets = 0;   ///< a counted cell: measure paths to so many, of solvers that have them
  std::string vectors;    ///< corpus/solvers.h
  std::vector<std::string> benchmark_flags = {};
  bool repair = false;  ///< repair the mesh first
};
GEODESIC_JSON_MEMBERS(CellSpec, solver, mesh, mesh_file, source, source_set, sources_file,
                      reference, reference_file, output, run_folder, counted, pictured, frames,
                      other_queries, path_targets, vectors, benchmark_flags, repair)

/// Distances to verify others by.
struct ReferenceSpec {
  std::string solver;
  std::string mesh_file;
  Index source = 0;               ///< vertex
  std::string sources_file = {};  ///< in place of it: several
  std::string output;             ///< distance file to write
  bool repair = false;            ///< repair the mesh first
};
GEODESIC_JSON_MEMBERS(ReferenceSpec, solver, mesh_file, source, sources_file, output, repair)

/// Prepares the solver, verifies a warm-up solve, asks for other sources and again, times solves
/// and, in a counted cell, records more on new solver objects; then writes the rows, after the
/// recordings of a pictured cell. Distances that are wrong, or that differ between these solves,
/// make one row with the error and no time.
/// @throws what the reader, the solver or the disk throws; the run makes an error row of it
void run_cell(const CellSpec& spec);

/// Solves once and writes the distances. @throws as run_cell
void run_reference(const ReferenceSpec& spec);

/// Does the work of such a process. What it throws becomes a line on standard error and an exit
/// code for failure_of.
int exit_code_of(const std::function<void()>& work);

struct Failure {
  Outcome outcome;
  std::string why;
};

/// Why such a process failed.
/// @param limits of the process
/// @throws CannotWrite when that was its reason: later cells could not write either
Failure failure_of(const Ended& ended, const ProcessLimits& limits);

}  // namespace geodesic::harness
