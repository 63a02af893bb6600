// What went wrong in the cells of a run, and what its exit code is for that.
#pragma once

#include <vector>

#include "harness/cells/plan.h"

namespace geodesic::harness {

/// Exit codes of a run; the worst thing that happened decides.
enum class RunResult { ok = 0, error = 1, wrong_answer = 2 };

/// Writes a line to standard error for every row that failed or could not be recorded, and for
/// every mesh that was skipped. What the suite expects, a solver that cannot do a mesh, a cell that
/// was skipped after another had failed, and a mesh that is not in the cache are no errors.
RunResult tell_failures(const std::vector<Json>& rows, const Plan& plan, const Suite& suite);

}  // namespace geodesic::harness
