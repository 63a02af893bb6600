#include "harness/run/summary.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

bool is_expected(const Row& row, const Suite& suite) {
  const auto expected = suite.expected.find(row.solver + '/' + row.mesh);
  return expected != suite.expected.end() && expected->second == row.outcome;
}

RunResult report_failure(const Row& row, const Suite& suite) {
  const std::string cell = row.name() + (row.program ? " by " + *row.program : "");
  if (row.outcome == Outcome::unsupported) return RunResult::ok;  // counted, and listed by check
  if (row.ok()) {
    if (row.repetition_index != 0 || !row.recordings_error) return RunResult::ok;
    std::cerr << cell << ": not recorded: " << *row.recordings_error << '\n';
    return RunResult::error;
  }
  const bool expected = is_expected(row, suite);
  std::cerr << cell << ": " << name_of(row.outcome) << (expected ? ", as expected: " : ": ")
            << row.error_message << '\n';
  if (expected || row.outcome == Outcome::skipped) return RunResult::ok;
  return row.outcome == Outcome::wrong_answer ? RunResult::wrong_answer : RunResult::error;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

// The number with `digits` significant digits, including zeros at the end: 2.500, 25.00. The
// exponent is that of the rounded number: 9.9996 is 10.00.
std::string fixed_digits(double x, int digits) {
  std::ostringstream rounded, text;
  rounded << std::scientific << std::setprecision(digits - 1) << x;
  const int exponent = std::stoi(rounded.str().substr(rounded.str().find('e') + 1));
  text << std::fixed << std::setprecision(std::max(digits - 1 - exponent, 0)) << x;
  return text.str();
}

std::string time_text(double ms) {
  if (ms < 1) return fixed_digits(1e3 * ms, 4) + " us";
  return ms < 1e3 ? fixed_digits(ms, 4) + " ms" : fixed_digits(1e-3 * ms, 4) + " s";
}

}  // namespace

void report_skipped(const Plan& plan) {
  for (const SkippedMesh& skipped : plan.skipped) {
    std::cerr << "skipped " << skipped.name << ": " << skipped.why << '\n';
  }
}

RunResult report_failures(const std::vector<Row>& rows, const Plan& plan, const Suite& suite) {
  RunResult result = RunResult::ok;
  for (const Row& row : rows) result = std::max(result, report_failure(row, suite));
  const bool unreadable = std::ranges::any_of(plan.skipped, &SkippedMesh::unreadable);
  return unreadable ? std::max(result, RunResult::error) : result;
}

std::string one_line(const std::vector<Row>& rows) {
  const Row& first = rows.front();
  if (!first.ok()) return std::string(name_of(first.outcome)) + ": " + first.error_message;
  std::vector<double> times;
  for (const Row& row : rows) times.push_back(row.solve_time());
  return "ok  " + time_text(median(times));
}

}  // namespace geodesic::harness
