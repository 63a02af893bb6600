// The arguments of the processes that a run starts, as JSON: `geodesic-bench cell SPEC` and
// `geodesic-bench reference SPEC`. A cell is one solver on one mesh from one source.
//
// A run may measure older builds (run --program), so this is an interface between revisions:
// members keep their names and meanings, and new ones are optional, with the old behaviour as
// default.
#pragma once

#include <string>
#include <vector>

#include "harness/base/json.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

struct CellSpec {
  std::string solver;
  std::string mesh;       ///< name
  std::string mesh_file;  ///< path
  Index source = 0;
  std::string reference;       ///< the solver that the distances are compared with
  std::string reference_file;  ///< its distances (verify/distance_file.h)
  std::string output;          ///< the result file to write
  std::string run_folder;
  bool counted = true;    ///< solve some more, for counters, memory and phases
  bool pictured = false;  ///< leave recordings in the run folder (recordings/pictured.h);
                          ///< only of counted cells
  std::string vectors;    ///< corpus/vectors.h
  std::vector<std::string> benchmark_flags;
  Json context;  ///< context.geodesic_bench of the result file
};
void to_json(Json& json, const CellSpec& spec);
void from_json(const Json& json, CellSpec& spec);

/// Distances to verify others by, computed in a process of their own.
struct ReferenceSpec {
  std::string solver;
  std::string mesh_file;
  Index source = 0;
  std::string output;  ///< distance file to write
};
void to_json(Json& json, const ReferenceSpec& spec);
void from_json(const Json& json, ReferenceSpec& spec);

}  // namespace geodesic::harness
