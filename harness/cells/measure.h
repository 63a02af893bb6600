// A cell's result, by a process of its own, whatever happens to that.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

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
/// @return the rows of the result file, at least one
/// @throws HarnessError when the result file cannot be written
Json measure_cell(const Cell& cell, CellSpec spec, References& references,
                  const std::function<void()>& waiting);

}  // namespace geodesic::harness
