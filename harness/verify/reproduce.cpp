#include "harness/verify/reproduce.h"

#include <algorithm>
#include <functional>
#include <iostream>

#include "harness/base/available_memory.h"
#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/base/process.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/shrink.h"
#include "meshes/mesh_file.h"
#include "meshes/messages.h"

namespace geodesic::harness {
namespace {

using Words = std::vector<std::string>;

struct Reproduction {
  Case given;
  std::filesystem::path file;  // empty for a mesh without faces, which no file holds
  Words command;               // arguments of geodesic-bench that reproduce the failure
  bool repeated = false;       // whether the command failed again, with the saved mesh
  CheckResult result;          // of the smallest case, explained
};

// Exit code of solve and verify.
constexpr int kFails = 2;

// Seconds for a smaller case. kLoop is for cases that do not end: each attempt takes all of it.
constexpr double kAttempt = 10;
constexpr double kLoop = 2;

Ended run(const Words& words, double seconds = kInfinity) {
  return run_geodesic_bench(words, [] {}, {.seconds = seconds, .memory_bytes = available_memory()});
}

// Whether the case has one query, or several queries of one source each without a limit.
bool fits_on_a_command_line(const Case& given) {
  const auto plain = [](const Query& query) {
    return query.sources.size() == 1 && query.limit == kInfinity;
  };
  return given.queries.size() == 1 || std::ranges::all_of(given.queries, plain);
}

// `solve` checks no distances with a limit.
bool fits_solve(const Query& query) { return query.limit == kInfinity; }

void append_sources(Words& words, const Case& given) {
  for (const Query& query : given.queries) {
    for (const Source& source : query.sources) {
      const std::string initial = source.distance > 0 ? '+' + significant(source.distance) : "";
      words.insert(words.end(), {"--source", std::to_string(source.at.vertex) + initial});
    }
  }
  if (given.queries.size() > 1) words.emplace_back("--each");
}

class Reproducer {
 public:
  Reproducer(const IsolatedCheck& check, const FailedProperty& failed)
      : check_(check),
        failed_(failed),
        attempt_(std::min(check.time_limit(), timed_out() ? kLoop : kAttempt)) {}

  Case shrunk(double seconds) const {
    const auto fails_within = [&](const Case& smaller, double limit) {
      return check_.on_case(*failed_.property, smaller, limit).fails_like(failed_.result);
    };
    Case smallest = shrink(
        failed_.given, failed_.result.query,
        [&](const Case& smaller) { return fails_within(smaller, attempt_); }, seconds);
    // A case that takes longer than an attempt may still end.
    const bool in_doubt = timed_out() && attempt_ < check_.time_limit();
    return in_doubt && !fails_within(smallest, kInfinity) ? failed_.given : smallest;
  }

  // Runs commands until one makes the saved case fail again.
  void find_command(Reproduction& saved) const {
    const bool on_file = !saved.file.empty() && failed_.property->on_any_mesh;
    if (on_file && fits_on_a_command_line(saved.given)) {
      for (const Words& words : {solve_words(saved), verify_words(&saved)}) {
        if (words.empty()) continue;
        saved.command = words;
        saved.repeated = repeats_it(words);
        if (saved.repeated) return;
      }
    }
    if (failed_.own || saved.command.empty()) saved.command = verify_words(nullptr);
    if (failed_.own) saved.repeated = repeats_it(saved.command);
  }

 private:
  bool timed_out() const { return failed_.result.outcome == CheckOutcome::timed_out; }

  // Empty when `solve` does not support the queries.
  Words solve_words(const Reproduction& saved) const {
    if (!std::ranges::all_of(saved.given.queries, fits_solve)) return {};
    Words words{"solve", saved.file.string(), "--solver", check_.solver().name};
    append_sources(words, saved.given);
    append_vectors(words);
    words.emplace_back("--check");
    // Compares a recorded solve with the first one.
    const bool of_recordings = failed_.property->name.starts_with("recordings");
    if (of_recordings && saved.given.queries.size() == 1) words.emplace_back("--counters");
    return words;
  }

  // @param saved null: on the property's own cases
  Words verify_words(const Reproduction* saved) const {
    Words words{"verify",   "--solver", check_.solver().name, "--property", failed_.property->name,
                "--shrink", "0"};
    append_vectors(words);
    if (timed_out()) words.insert(words.end(), {"--time-limit", significant(check_.time_limit())});
    if (saved == nullptr) return words;
    words.insert(words.end(), {"--meshes", saved->file.string()});
    append_sources(words, saved->given);
    const double limit = saved->given.queries.front().limit;
    if (limit < kInfinity) words.insert(words.end(), {"--limit", significant(limit)});
    return words;
  }

  void append_vectors(Words& words) const {
    if (check_.vectors() == kAutoVectors) return;
    words.insert(words.end(), {"--vectors", check_.vectors()});
  }

  bool repeats_it(const Words& words) const {
    if (words.front() == "verify") return run(words).code == kFails;
    const Ended ended = run(words, attempt_);
    if (timed_out()) return ended.timed_out;
    if (failed_.result.outcome == CheckOutcome::crashed) return ended.crashed;
    if (!failed_.result.what.starts_with(kThrew)) return ended.code == kFails;
    const std::string message = failed_.result.what.substr(std::string(kThrew).size());
    return ended.error_lines.find(message) != std::string::npos;
  }

  const IsolatedCheck& check_;
  const FailedProperty& failed_;
  const double attempt_;
};

void save(const Case& given, const std::filesystem::path& file) {
  if (file.has_parent_path()) make_folder(file.parent_path(), "; --out names another");
  write_bytes(file, mesh_bytes(given.soup, file));
}

/// Shrinks the case and writes it. @param file to write; its folder is made
Reproduction save_smallest(const IsolatedCheck& check, const FailedProperty& failed,
                           const std::filesystem::path& file, double seconds) {
  const Reproducer reproducer(check, failed);
  Reproduction saved{.given = failed.given, .file = {}, .command = {}, .result = failed.result};
  if (!failed.given.soup.triangles.empty()) {
    if (failed.property->on_any_mesh) saved.given = reproducer.shrunk(seconds);
    saved.file = file;
    save(saved.given, file);
  }
  reproducer.find_command(saved);
  if (failed.result.outcome != CheckOutcome::wrong || saved.file.empty()) return saved;
  const CheckResult explained = check.on_case(*failed.property, saved.given, kInfinity, true);
  if (explained.failed()) saved.result = explained;
  return saved;
}

void print_explanation(const CheckResult& result) {
  for (const std::string& line : result.explanation) std::cout << "  " << line << '\n';
  std::cout.flush();
}

}  // namespace

void FailureReport::show(const IsolatedCheck& check, const FailedProperty& failed) {
  std::cout << '\n' << failed.name << '\n';
  const TriangleSoup& all = failed.given.soup;
  if (!(seconds_ > 0)) {
    if (failed.result.outcome != CheckOutcome::wrong || all.triangles.empty()) return;
    return print_explanation(check.on_case(*failed.property, failed.given, kInfinity, true));
  }
  const Reproduction saved = save_smallest(check, failed, unused_file(failed), seconds_);
  const TriangleSoup& few = saved.given.soup;
  if (!saved.file.empty()) {
    std::cout << "  smallest case  " << saved.file.string() << ": " << few.positions.size()
              << " vertices and " << few.triangles.size() << " faces of the "
              << all.positions.size() << " and " << all.triangles.size() << " of '"
              << failed.given.mesh << "'\n";
  }
  std::cout << "  fails there    " << saved.result.what << '\n'
            << "  reproduce it   " << as_command_line(saved.command) << '\n';
  if (!saved.repeated) {
    std::cout << "                 (when tried, it did not fail again: the answer may change "
                 "from one solve to the next)\n";
  }
  print_explanation(saved.result);
}

// Meshes of different folders may have the same name. Files of earlier calls are overwritten.
std::filesystem::path FailureReport::unused_file(const FailedProperty& failed) {
  // "distances-equal-the-reference-on-hill"
  std::string stem = failed.property->name + "-on-" + failed.given.mesh;
  std::ranges::replace_if(stem, std::not_fn(is_plain), '-');
  std::filesystem::path file = folder_ / (stem + ".obj");
  for (int i = 2; !written_.insert(file).second; ++i) {
    file = folder_ / (stem + '-' + std::to_string(i) + ".obj");
  }
  return file;
}

}  // namespace geodesic::harness
