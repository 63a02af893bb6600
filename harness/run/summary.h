// What a run ends with: what failed, and its exit code. Results are judged by results/outcomes.py.
#pragma once

#include <string>
#include <vector>

#include "harness/results/row.h"
#include "harness/run/plan.h"

namespace geodesic::harness {

/// Exit codes of a run; the worst thing that happened decides.
enum class RunResult { ok = 0, error = 1, wrong_answer = 2 };

/// Writes a line to standard error for every row that failed or could not be recorded, and one for
/// every mesh that was skipped. Outcomes that the suite
/// expects, unsupported meshes, cells that were skipped after a failure, and meshes that are not in
/// the cache are no errors.
RunResult report_failures(const std::vector<Row>& rows, const Plan& plan, const Suite& suite);

/// "ok  12.3 ms", "wrong answer: vertex 7 has ..."
/// @param rows of one cell
std::string one_line(const std::vector<Row>& rows);

}  // namespace geodesic::harness
