#include "harness/verify/isolated_check.h"

#include <algorithm>
#include <csignal>
#include <fstream>

#include "harness/base/control_groups.h"
#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/base/process.h"
#include "harness/verify/check_process.h"
#include "harness/verify/saved_case.h"
#include "meshes/messages.h"
#include "meshes/oracles/random_case.h"

namespace geodesic::harness {
namespace {

// What the log of a process says of one check.
struct Logged {
  std::size_t index = 0;
  std::size_t kind = 0;     // of the random mesh
  bool has_result = false;  // false only for the last check of a process that it ended
  std::string reference{};  // that was computing last; empty: none
  CheckResult result{};
};

std::vector<Logged> read_log(const std::filesystem::path& file) {
  std::vector<Logged> found;
  std::ifstream log(file);
  for (std::string text; std::getline(log, text);) {
    const Json line = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (line.is_discarded()) break;  // the last line of a process that was killed
    if (line.contains("ask")) {
      found.push_back({line["ask"].get<std::size_t>(), line["kind"].get<std::size_t>()});
    } else if (line.contains("case")) {
      found.back().result.at_case = line["case"].get<std::size_t>();
    } else if (line.contains("reference")) {
      found.back().reference = line["reference"].get<std::string>();
    } else if (line.contains("result")) {
      found.back().result = line["result"].get<CheckResult>();
      found.back().has_result = true;
    } else {
      found.back().result.explanation = line["explanation"].get<std::vector<std::string>>();
    }
  }
  return found;
}

// The result of a check that ended its process, or was ended.
CheckResult without_result(const Logged& logged, const Ended& ended, double seconds) {
  const bool timed_out = ended.crashed && ended.code == SIGALRM;
  CheckResult result = logged.result;
  result.outcome = timed_out ? CheckOutcome::timed_out : CheckOutcome::crashed;
  result.what = timed_out ? "did not end within " + significant(seconds, 6) + " s"
                          : "ended the process: " + ended.describe();
  if (!timed_out) {
    result.kind = (ended.crashed ? "signal " : "exit code ") + std::to_string(ended.code);
  }
  if (!logged.reference.empty()) {
    result.outcome = CheckOutcome::not_known;
    result.what = "the reference, " + logged.reference + ", " + result.what;
  }
  return result;
}

}  // namespace

Case random_mesh_case(const RandomNumber& of, const std::filesystem::path& scratch) {
  RandomCase made = random_case(of.seed, of.number, scratch);
  return {.mesh = made.recipe,
          .soup = std::move(made.soup),
          .queries = {made.query},
          .tolerance = {.least = made.least_distance}};
}

void check_apart(const std::vector<Ask>& asks, const std::string& vectors,
                 const ScratchFolder& scratch, std::uint64_t memory_bytes,
                 const std::function<bool(const Ask&)>& wanted,
                 const std::function<void(std::size_t, CheckResult, std::size_t)>& ended) {
  const CheckTask files{.vectors = vectors,
                        .scratch = scratch.path().string(),
                        .log = (scratch / "log.jsonl").string()};
  const std::filesystem::path task_file = scratch / "task.json";
  for (std::size_t next = 0; next < asks.size();) {
    CheckTask task = files;
    std::vector<std::size_t> numbers;  // of the task's checks
    for (; next < asks.size(); ++next) {
      if (!wanted(asks[next])) continue;
      task.asks.push_back(asks[next]);
      numbers.push_back(next);
    }
    if (task.asks.empty()) return;
    write_json(task_file, task);
    std::filesystem::remove(task.log);
    const auto take = [&](const Logged& logged, CheckResult result) {
      ended(numbers.at(logged.index), std::move(result), logged.kind);
    };
    Ended process;
    try {
      process = run_geodesic_bench({"check-cases", task_file.string()}, [] {},
                                   {.memory_bytes = memory_bytes});
    } catch (const Interrupted&) {
      for (const Logged& logged : read_log(task.log)) {
        if (logged.has_result) take(logged, logged.result);
      }
      throw;
    }
    const std::vector<Logged> found = read_log(task.log);
    if (found.empty()) throw HarnessError("check: " + process.describe());
    for (const Logged& logged : found) {
      const double seconds = task.asks.at(logged.index).seconds;
      take(logged, logged.has_result ? logged.result : without_result(logged, process, seconds));
    }
    next = numbers.at(found.back().index) + 1;
  }
}

CheckResult IsolatedCheck::result_of(const Ask& ask) const {
  CheckResult found;
  check_apart(
      {ask}, vectors_, folder_, available_memory(), [](const Ask&) { return true; },
      [&](std::size_t, CheckResult result, std::size_t) { found = std::move(result); });
  return found;
}

CheckResult IsolatedCheck::on_own_cases(const Property& property) const {
  return result_of({.solver = solver_.name, .property = property.name, .seconds = time_limit_});
}

CheckResult IsolatedCheck::on_case(const Property& property, const Case& given, double seconds,
                                   bool explain) const {
  const std::filesystem::path file = folder_ / "case.json";
  write_case({solver_.name, property.name, vectors_, given}, file);
  return result_of({.solver = solver_.name,
                    .property = property.name,
                    .file = file.string(),
                    .seconds = std::min(seconds, time_limit_),
                    .explain = explain});
}

}  // namespace geodesic::harness
