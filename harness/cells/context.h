// What result files say of the run they belong to (results/README.md, `context`).
#pragma once

#include <string>
#include <vector>

#include "harness/cells/plan.h"

namespace geodesic::harness {

/// context.geodesic_bench of some of a run's meshes and solvers, started now, with nothing skipped.
/// @param command the command line, for the record
Json run_context(const Suite& suite, const std::vector<const PlannedMesh*>& meshes,
                 const std::vector<const Description*>& solvers, const std::string& command);

/// The same of a whole run, with what it skips.
Json run_context(const Suite& suite, const Plan& plan, const std::string& command);

}  // namespace geodesic::harness
