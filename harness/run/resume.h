// The files of an interrupted run, and the check whether the run may be resumed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/results/row.h"
#include "harness/run/cell.h"
#include "harness/run/plan.h"

namespace geodesic::harness {

/// Adds the identity of the program, the solvers and the meshes to the request, and the start. A
/// request that resumes a run gets the command, the start and the accepted changes of that run.
/// @throws HarnessError when the run to resume had another identity and the request does not accept
///         changes; accepted changes are listed on standard error
void identify(RunRequest& request, const Plan& plan);

/// The data about the whole run in the result file of a shard (results/README.md).
/// @param request after `identify`
Json shard_context(const RunRequest& request, const Plan& plan);

/// Writes request.json. @param request after `identify`
void save_request(const RunRequest& request, const std::filesystem::path& folder);

/// Loads the plug-ins of the folder's run that are not loaded yet. @throws HarnessError as
/// load_by_option, and when request.json is missing or invalid
void load_plugins_of(const std::filesystem::path& folder);

/// Reads request.json, as the request that resumes the run.
/// @throws HarnessError when the file is missing or invalid
RunRequest saved_request(const std::filesystem::path& folder);

/// Removes unfinished files of processes that were killed.
void remove_parts_of_files(const std::filesystem::path& folder);

/// The rows of the cell's result file, with their processor; nothing when there is no file. A file
/// that is damaged, belongs to another cell or lacks its recordings is reported on standard error
/// and removed.
std::optional<std::vector<Row>> kept_rows(const Cell& cell, const CellSpec& spec);

}  // namespace geodesic::harness
