// The process of check_apart (isolated_check.h). It writes each step to a log, so that the process
// that started it knows during which check it ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/verify/isolated_check.h"

namespace geodesic::harness {

struct CheckTask {
  std::vector<Ask> asks = {};
  std::string vectors;  ///< name of the instruction set
  std::string scratch;  ///< folder for random_case
  /// File of lines of JSON. {"ask": index, "kind": of the random mesh} begins a check,
  /// {"case": index} its next case, {"reference": name} the work of a reference ("" when it has
  /// answered); {"result": CheckResult} ends it, and {"explanation": [lines]} may follow.
  std::string log;
};
GEODESIC_JSON_MEMBERS(CheckTask, asks, vectors, scratch, log)

/// Makes the checks of a task. @param file of JSON
void run_checks(const std::filesystem::path& file);

}  // namespace geodesic::harness
