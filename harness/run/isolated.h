// Measures the rows of a cell in a separate process, whatever happens to that process.
#pragma once

#include <functional>
#include <vector>

#include "harness/results/row.h"
#include "harness/run/cell.h"
#include "harness/run/plan.h"
#include "harness/run/reference_files.h"

namespace geodesic::harness {

/// The limits of the suite on the process of a cell.
ProcessLimits limits_of(const Suite& suite);

/// Finds the reference for the cell and runs its process. An unsupported mesh, a missing reference
/// or a failed process becomes a row with the reason.
/// @param spec complete except for the reference
/// @param waiting called about once a second while the cell's process runs
/// @return at least one row
/// @throws CannotWrite when the process cannot write
/// @throws Interrupted (interruption.h)
std::vector<Row> measure_cell(const Cell& cell, const CellSpec& spec, ReferenceFiles& references,
                              const ProcessLimits& limits, const std::function<void()>& waiting);

/// The row of a cell without a time.
Row failed_row(const Cell& cell, const Failure& failure);

}  // namespace geodesic::harness
