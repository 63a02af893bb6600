// What a run is asked for, and request.json: the same in its folder, by which it can be gone on
// with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/cells/pictured.h"
#include "harness/cells/plan.h"
#include "harness/corpus/suite.h"

namespace geodesic::harness {

/// Another build of geodesic-bench, whose solvers a run measures.
struct ProgramFile {
  std::string name;
  std::filesystem::path file;
};

struct RunRequest {
  Suite suite;
  std::filesystem::path manifest;
  std::optional<std::filesystem::path> out;  ///< by default `results/runs/<UTC time>-<corpus>`
  std::vector<std::string> benchmark_flags;
  Pictured pictured = Pictured::automatic;
  bool interleave = false;            ///< every repetition a process of its own (Plan::cells)
  std::vector<ProgramFile> programs;  ///< measured in place of this one; none, or two or more
  std::vector<std::string> cells;     ///< names of rows: only these; empty: all
  unsigned threads = 1;  ///< reference distances computed at a time; nothing is timed meanwhile
  std::string command;   ///< the command line, for the record
  std::optional<std::filesystem::path> resume = {};  ///< folder of the run to go on with
  bool accept_changes = false;                       ///< though it was asked for something else
};

/// What decides about the results of a run: the program, the options, the solvers, the meshes.
Json identity(const RunRequest& request, const Plan& plan);

struct SavedRequest {
  RunRequest request;
  Json identity;                     ///< when it was last gone on with
  std::string started;               ///< as utc_now has it
  std::vector<std::string> changes;  ///< accepted since then
};

/// Writes request.json.
void save_request(const SavedRequest& saved, const std::filesystem::path& folder);

/// Reads request.json. @throws HarnessError when there is none, or it is not what was written
SavedRequest saved_request(const std::filesystem::path& folder);

/// "options/seed is 2 and was 1", for every value of two identities that differs.
std::vector<std::string> differences(const Json& before, const Json& now);

}  // namespace geodesic::harness
