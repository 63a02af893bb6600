#include "harness/cells/failures.h"

#include <algorithm>
#include <iostream>

#include "harness/cells/row.h"

namespace geodesic::harness {
namespace {

RunResult tell(const Json& row) {
  const std::string name = row.at("name"), outcome = row.at("outcome");
  if (outcome == outcome::kOk) {
    if (row.at("repetition_index") != 0 || !row.contains("recordings_error")) return RunResult::ok;
    std::cerr << name << ": not recorded: " << row.at("recordings_error").get<std::string>()
              << '\n';
    return RunResult::error;
  }
  std::cerr << name << ": " << outcome << ": " << row.at("error_message").get<std::string>()
            << '\n';
  if (outcome == outcome::kUnsupported) return RunResult::ok;
  return outcome == outcome::kWrongAnswer ? RunResult::wrong_answer : RunResult::error;
}

}  // namespace

RunResult tell_failures(const std::vector<Json>& rows, const Plan& plan) {
  RunResult result = RunResult::ok;
  for (const Json& row : rows) result = std::max(result, tell(row));
  for (const SkippedMesh& skipped : plan.skipped) {
    std::cerr << "skipped " << skipped.name << ": " << skipped.why << '\n';
    if (skipped.unreadable) result = std::max(result, RunResult::error);
  }
  return result;
}

}  // namespace geodesic::harness
