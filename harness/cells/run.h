// A run: every cell of a suite in a process of its own, and run.json made of what they wrote.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/cells/failures.h"
#include "harness/corpus/suite.h"
#include "harness/recordings/pictured.h"

namespace geodesic::harness {

struct RunRequest {
  Suite suite;
  std::filesystem::path manifest;
  std::optional<std::filesystem::path> out;  ///< by default `results/runs/<UTC time>-<corpus>`
  std::vector<std::string> benchmark_flags;
  Pictured pictured = Pictured::automatic;
  unsigned threads = 1;  ///< reference distances computed at a time; nothing is timed meanwhile
  std::string command;   ///< the command line, for the record
};

/// Runs the suite. Whatever happens inside a cell becomes a row and never ends the run. Progress
/// goes to standard error, the path of run.json to standard output.
/// @throws HarnessError when the request makes no sense or the run folder cannot be written
RunResult run(const RunRequest& request);

}  // namespace geodesic::harness
