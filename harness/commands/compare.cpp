#include "harness/commands/compare.h"

#include <iostream>
#include <memory>

#include "harness/compare/compare.h"
#include "harness/compare/limits.h"
#include "harness/compare/report.h"

namespace geodesic::harness {
namespace {

constexpr int kWrongAnswer = 2, kRegression = 3;  // exit codes

struct CompareFlags {
  std::string before, after;
  std::vector<std::string> fail_on;
  std::string format = "text";
};

int run_compare(const CompareFlags& flags) {
  const ReportFormat format = report_format_named(flags.format);
  const Limits limits = parse_limits(flags.fail_on);
  const ResultFile before = read_result_file(flags.before);
  const Comparison comparison = compare(before, read_result_file(flags.after));
  const std::vector<std::string> failures = exceeded(comparison, limits);
  std::cout << report(comparison, failures, format);
  if (comparison.count_wrong() > 0) return kWrongAnswer;
  return failures.empty() ? 0 : kRegression;
}

}  // namespace

void add_compare_command(CLI::App& app) {
  const auto flags = std::make_shared<CompareFlags>();
  CLI::App* command = app.add_subcommand("compare", "Two finished runs: what differs");
  command->add_option("old", flags->before, "a result file or run folder")->required();
  command->add_option("new", flags->after, "another, of the same corpus")->required();
  command
      ->add_option("--fail-on", flags->fail_on,
                   "limits of growth: exit code 3 above time=10%,counters=1%,memory=2% for example")
      ->delimiter(',');
  command->add_option("--format", flags->format, "text, markdown or json")->capture_default_str();
  command->callback([flags] {
    if (const int code = run_compare(*flags)) throw CLI::RuntimeError(code);
  });
}

}  // namespace geodesic::harness
