// What an interrupted run left, and whether a run may continue it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/results/row.h"
#include "harness/run/cell.h"
#include "harness/run/plan.h"

namespace geodesic::harness {

/// request.json of a run folder.
struct SavedRequest {
  RunRequest request;
  Json identity;                     ///< what decides about the results, when last started
  std::string started;               ///< as utc_now has it
  std::vector<std::string> changes;  ///< accepted since then
};

/// The request with the program, the solvers and the meshes. One that resumes a run keeps the
/// command and the start of that run.
/// @throws HarnessError when the run to resume had another identity, unless that is accepted, which
///         is then said on standard error
SavedRequest identify(const RunRequest& request, const Plan& plan);

/// What a shard's result file says of the run that it is a part of (results/README.md).
Json shard_context(const SavedRequest& saved, const Plan& plan);

/// Writes request.json.
void save_request(const SavedRequest& saved, const std::filesystem::path& folder);

/// Reads request.json. @throws HarnessError when there is none, or it is not what was written
SavedRequest saved_request(const std::filesystem::path& folder);

/// Removes unfinished files of processes that were killed.
void remove_parts_of_files(const std::filesystem::path& folder);

/// The rows of the cell's result file, with their processor; nothing where there is none. A file
/// that is damaged or belongs to another cell, or whose recordings are missing, is named on
/// standard error and removed.
std::optional<std::vector<Row>> kept_rows(const Cell& cell, const CellSpec& spec);

}  // namespace geodesic::harness
