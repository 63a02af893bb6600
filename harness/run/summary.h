// The end of a run: its failures and its exit code. results/outcomes.py judges results.
#pragma once

#include <string>
#include <vector>

#include "harness/results/row.h"
#include "harness/run/plan.h"

namespace geodesic::harness {

/// Exit codes of a run. The worst failure decides.
enum class RunResult { ok = 0, error = 1, wrong_answer = 2 };

/// Writes a line to standard error for every skipped mesh.
void report_skipped(const Plan& plan);

/// Writes a line to standard error for every row that failed or could not be recorded. Outcomes
/// that the suite expects, unsupported meshes, cells that were skipped after a failure, and meshes
/// that are not in the cache are no errors.
RunResult report_failures(const std::vector<Row>& rows, const Plan& plan, const Suite& suite);

/// The result of a cell in one line: "ok  12.3 ms", "wrong answer: vertex 7 has ..."
/// @param rows of one cell
std::string one_line(const std::vector<Row>& rows);

}  // namespace geodesic::harness
