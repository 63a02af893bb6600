// A cell's result, by a process of its own, whatever happens to that.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "harness/base/limits.h"
#include "harness/cells/plan.h"
#include "harness/cells/references.h"
#include "harness/cells/spec.h"

namespace geodesic::harness {

/// What the process of a suite's cell is told, but for its reference. Its result goes to `cells/`
/// of the folder; the flags for Google Benchmark are the suite's.
/// @param command the command line, for the record
CellSpec cell_spec(const Suite& suite, const Cell& cell, const std::filesystem::path& folder,
                   const std::string& command);

/// Finds the distances to verify the cell by, runs its process and reads what it wrote. Where the
/// solver cannot do the mesh, nothing verifies it, or the process fails, the result file has an
/// error row instead.
/// @param spec its output does not exist yet
/// @param waiting called about once a second while the cell's process runs
/// @param limits of the cell's process
/// @return the rows of the result file, at least one
/// @throws CannotWrite when the result file cannot be written
/// @throws Interrupted (interruption.h); then there is no result file
Json measure_cell(const Cell& cell, CellSpec spec, References& references,
                  const ProcessLimits& limits, const std::function<void()>& waiting);

/// Writes the result file of a cell that has no time.
void write_failure(const Cell& cell, const CellSpec& spec, const char* outcome,
                   const std::string& why);

}  // namespace geodesic::harness
