#include "harness/verify/smallest.h"

#include <errno.h>

#include <algorithm>
#include <cctype>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/base/process.h"
#include "harness/corpus/vectors.h"
#include "harness/verify/shrink.h"
#include "meshes/mesh_file.h"

namespace geodesic::conformance {
namespace {

using Words = std::vector<std::string>;

// Seconds that a smaller case may take; those that do not end cost as much at every attempt.
constexpr double kAttempt = 10;
constexpr double kLoop = 2;

double attempt_seconds(const Examiner& examiner, const Report& failed) {
  return std::min(examiner.time_limit(), failed.outcome == Outcome::timed_out ? kLoop : kAttempt);
}

// Many queries of one source each, or one query.
bool can_be_words(const Case& given) {
  const auto plain = [](const Query& query) {
    return query.sources.size() == 1 && query.limit == kInfinity;
  };
  return given.queries.size() == 1 || std::ranges::all_of(given.queries, plain);
}

void append_sources(Words& words, const Case& given) {
  for (const Query& query : given.queries) {
    for (const Source& source : query.sources) {
      const std::string initial = source.distance > 0 ? ':' + significant(source.distance) : "";
      words.insert(words.end(), {"--source", std::to_string(source.vertex) + initial});
    }
  }
  if (given.queries.size() > 1) words.emplace_back("--each");
}

// Looks for a command that makes a saved case fail again, by running it.
class Reproduction {
 public:
  Reproduction(const Examiner& examiner, const Property& property, const Report& failed)
      : examiner_(examiner), property_(property), failed_(failed) {}

  /// @param own whether the property's own cases are such commands too
  void find(Smallest& smallest, bool own) const {
    const bool on_file = !smallest.file.empty() && property_.on_any_mesh;
    if (on_file && can_be_words(smallest.given)) {
      smallest.repeated = solves_wrongly(smallest) || fails_on_file(smallest);
      if (smallest.repeated) return;
    }
    if (own || smallest.command.empty()) smallest.command = verify_words();
    if (own) smallest.repeated = run(smallest.command, kInfinity).code == kFails;
  }

 private:
  static constexpr int kFails = 2;  // exit code

  static harness::Ended run(const Words& words, double seconds) {
    return harness::run_this_program(
        words, [] {}, {.seconds = seconds, .memory_bytes = harness::available_memory()});
  }

  bool solves_wrongly(Smallest& smallest) const {
    for (const Query& query : smallest.given.queries) {
      const auto starts_late = [](const Source& source) { return source.distance > 0; };
      if (query.limit < kInfinity || std::ranges::any_of(query.sources, starts_late)) return false;
    }
    Words words{"solve", smallest.file.string(), "--solver", examiner_.solver().name};
    append_sources(words, smallest.given);
    append_vectors(words);
    words.emplace_back("--check");
    if (!is_the_failure(run(words, attempt_seconds(examiner_, failed_)))) return false;
    smallest.command = words;
    return true;
  }

  bool is_the_failure(const harness::Ended& ended) const {
    if (failed_.outcome == Outcome::timed_out) return ended.timed_out;
    if (failed_.outcome == Outcome::crashed) return ended.crashed;
    if (!failed_.what.starts_with(kThrew)) return ended.code == kFails;
    const std::string message = failed_.what.substr(std::string(kThrew).size());
    return ended.error_lines.find(message) != std::string::npos;
  }

  bool fails_on_file(Smallest& smallest) const {
    Words words = verify_words();
    words.insert(words.end(), {"--meshes", smallest.file.string()});
    append_sources(words, smallest.given);
    const double limit = smallest.given.queries.front().limit;
    if (limit < kInfinity) words.insert(words.end(), {"--limit", significant(limit)});
    smallest.command = words;
    return run(words, kInfinity).code == kFails;
  }

  Words verify_words() const {
    Words words{"verify",   "--solver", examiner_.solver().name, "--property", property_.name,
                "--shrink", "0"};
    append_vectors(words);
    if (failed_.outcome == Outcome::timed_out) {
      words.insert(words.end(), {"--time-limit", significant(examiner_.time_limit())});
    }
    return words;
  }

  void append_vectors(Words& words) const {
    if (examiner_.vectors() == harness::kAutoVectors) return;
    words.insert(words.end(), {"--vectors", examiner_.vectors()});
  }

  const Examiner& examiner_;
  const Property& property_;
  const Report& failed_;
};

Case shrunk(const Examiner& examiner, const Property& property, const Case& given,
            const Report& failed, double seconds) {
  const double attempt = attempt_seconds(examiner, failed);
  const auto still_fails = [&](const Case& smaller) {
    return examiner.examine(property, smaller, attempt).fails_like(failed);
  };
  Case smallest = shrink(given, failed.query, still_fails, seconds);
  // What takes longer than an attempt may end all the same.
  const bool in_doubt = failed.outcome == Outcome::timed_out && attempt < examiner.time_limit();
  if (in_doubt && !examiner.examine(property, smallest).fails_like(failed)) return given;
  return smallest;
}

void save(const Case& given, const std::filesystem::path& file) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  if (error) {
    throw harness::HarnessError("cannot make the folder '" + file.parent_path().string() +
                                "' for failing meshes: " + error.message() +
                                "; --out names another");
  }
  harness::write_bytes(file, mesh_bytes(given.soup, file));
}

}  // namespace

Smallest save_smallest(const Examiner& examiner, const Property& property, const Case& given,
                       const Report& failed, bool own, const std::filesystem::path& file,
                       double seconds) {
  Smallest smallest{.given = given, .file = {}, .command = {}, .report = failed};
  if (!given.soup.triangles.empty()) {
    if (property.on_any_mesh) {
      smallest.given = shrunk(examiner, property, given, failed, seconds);
    }
    smallest.file = file;
    save(smallest.given, file);
  }
  Reproduction(examiner, property, failed).find(smallest, own);
  if (failed.outcome != Outcome::wrong || smallest.file.empty()) return smallest;
  const Report explained = examiner.explain(property, smallest.given);
  if (explained.failed()) smallest.report = explained;
  return smallest;
}

}  // namespace geodesic::conformance
