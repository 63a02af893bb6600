// A cell's rows, measured in a process of its own, whatever happens to that process.
#pragma once

#include <functional>
#include <vector>

#include "harness/results/row.h"
#include "harness/run/cell.h"
#include "harness/run/plan.h"
#include "harness/run/references.h"

namespace geodesic::harness {

/// The limits of the suite on the process of a cell.
ProcessLimits limits_of(const Suite& suite);

/// Finds the distances to verify the cell by and runs its process. A wrong answer by an independent
/// oracle is measured again by another reference where that differs from the oracle. Where the
/// solver cannot do the mesh, nothing verifies it, or the process fails, the row says so.
/// @param spec complete but for the reference
/// @param waiting called about once a second while the cell's process runs
/// @return at least one row
/// @throws CannotWrite when the process cannot write
/// @throws Interrupted (interruption.h)
std::vector<Row> measure_cell(const Cell& cell, const CellSpec& spec, References& references,
                              const ProcessLimits& limits, const std::function<void()>& waiting);

/// The row of a cell that has no time.
Row failed_row(const Cell& cell, const Failure& failure);

}  // namespace geodesic::harness
