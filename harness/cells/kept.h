// Results of cells that an interrupted run left.
#pragma once

#include <optional>

#include "harness/cells/plan.h"
#include "harness/cells/spec.h"

namespace geodesic::harness {

/// Removes what processes left that were killed while they wrote.
void remove_parts_of_files(const std::filesystem::path& folder);

/// The rows of the cell's result file; nothing where there is none. A file that is damaged or
/// belongs to another cell, or whose recordings are missing, is told on standard error and removed.
std::optional<Json> kept_rows(const Cell& cell, const CellSpec& spec);

}  // namespace geodesic::harness
