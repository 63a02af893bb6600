// A cell's result, measured in a process of its own, whatever happens to that process.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/cells/cell.h"
#include "harness/cells/plan.h"
#include "harness/cells/references.h"
#include "harness/results/row.h"

namespace geodesic::harness {

/// The limits of the suite on the process of a cell.
ProcessLimits limits_of(const Suite& suite);

/// Finds the distances to verify the cell by, runs its process and writes `spec.output`. Where the
/// solver cannot do the mesh, nothing verifies it, or the process fails, the file has an error row.
/// @param spec complete but for the reference; its output does not exist yet
/// @param waiting called about once a second while the cell's process runs
/// @return the rows of the result file, at least one
/// @throws CannotWrite when the result file cannot be written
/// @throws Interrupted (interruption.h); then there is no result file
std::vector<Row> measure_cell(const Cell& cell, CellSpec spec, References& references,
                              const ProcessLimits& limits, const std::function<void()>& waiting);

/// Writes the result file of a cell that has no time. @return its row
std::vector<Row> write_failure(const Cell& cell, const CellSpec& spec, Outcome outcome,
                               const std::string& why);

}  // namespace geodesic::harness
