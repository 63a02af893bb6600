#include "harness/cells/failures.h"

#include <algorithm>
#include <iostream>

#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

bool is_expected(const Json& row, const Suite& suite) {
  const std::string cell =
      row.at("solver").get<std::string>() + '/' + row.at("mesh").get<std::string>();
  const auto expected = suite.expected.find(cell);
  return expected != suite.expected.end() && expected->second == row.at("outcome");
}

RunResult tell(const Json& row, const Suite& suite) {
  const std::string name = row.at("name"), outcome = row.at("outcome");
  if (outcome == outcome::kOk) {
    if (row.at("repetition_index") != 0 || !row.contains("recordings_error")) return RunResult::ok;
    std::cerr << name << ": not recorded: " << row.at("recordings_error").get<std::string>()
              << '\n';
    return RunResult::error;
  }
  const bool expected = is_expected(row, suite);
  std::cerr << name << ": " << outcome << (expected ? ", as expected: " : ": ")
            << row.at("error_message").get<std::string>() << '\n';
  if (expected || outcome == outcome::kUnsupported || outcome == outcome::kSkipped) {
    return RunResult::ok;
  }
  return outcome == outcome::kWrongAnswer ? RunResult::wrong_answer : RunResult::error;
}

}  // namespace

RunResult tell_failures(const std::vector<Json>& rows, const Plan& plan, const Suite& suite) {
  RunResult result = RunResult::ok;
  for (const Json& row : rows) result = std::max(result, tell(row, suite));
  for (const SkippedMesh& skipped : plan.skipped) {
    std::cerr << "skipped " << skipped.name << ": " << skipped.why << '\n';
    if (skipped.unreadable) result = std::max(result, RunResult::error);
  }
  return result;
}

}  // namespace geodesic::harness
