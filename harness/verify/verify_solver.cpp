#include "harness/verify/verify_solver.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/interruption.h"
#include "harness/base/plugins.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/verify/random_check.h"
#include "harness/verify/references.h"
#include "harness/verify/reproduce.h"
#include "harness/verify/saved_case.h"
#include "meshes/mesh_file.h"
#include "meshes/oracles/random_meshes.h"

namespace geodesic::harness {
namespace {

constexpr int kSources = 3;         // per mesh
constexpr std::uint64_t kSeed = 1;  // for the choice of sources
constexpr std::size_t kShown = 3;   // failures that are shrunk and explained

std::vector<Query> queries_of(const VerifyRequest& request, const MeshEntry& entry,
                              const TriangleSoup& soup) {
  std::vector<Source> sources = request.sources;
  const bool each = request.each || sources.empty();
  if (sources.empty()) {
    for (const Index v : choose_sources(soup, entry.name, kSources, kSeed)) sources.push_back({v});
  }
  std::vector<Query> queries;
  for (const Source& source : sources) {
    if (source.at.vertex >= soup.positions.size()) {
      throw HarnessError("source vertex " + std::to_string(source.at.vertex) + " is not in '" +
                         entry.name + "', which has " + std::to_string(soup.positions.size()) +
                         " vertices");
    }
    if (each || queries.empty()) queries.push_back({.sources = {}, .limit = request.limit});
    queries.back().sources.push_back(source);
  }
  return queries;
}

Case case_of(const VerifyRequest& request, const MeshEntry& entry) {
  TriangleSoup soup = read_mesh_file(entry.file).soup;
  try {
    const Mesh buildable(soup);
  } catch (const std::invalid_argument& error) {
    throw HarnessError(entry.file.string() + ": " + error.what() +
                       " (geodesic-bench mesh lists the defects of a file)");
  }
  const std::vector<Query> queries = queries_of(request, entry, soup);
  return {.mesh = entry.name, .soup = std::move(soup), .queries = queries};
}

std::vector<MeshEntry> meshes_of(const VerifyRequest& request) {
  std::vector<MeshEntry> entries;
  if (!request.corpus.empty()) {
    entries = Manifest(request.manifest, dataset_cache()).corpus(request.corpus);
  }
  for (const std::string& mesh : request.meshes) {
    entries.push_back(find_mesh(mesh, request.manifest));
  }
  return entries;
}

void print_line(const std::string& outcome, const std::string& name, const std::string& why) {
  constexpr std::size_t kColumn = 13;
  std::cout << "  " << outcome << std::string(kColumn - outcome.size(), ' ') << name << '\n';
  if (!why.empty()) std::cout << std::string(kColumn + 4, ' ') << why << '\n';
  std::cout.flush();
}

/// Windows that a solver propagates on a terrain and a sphere; nothing if it counts none or
/// refuses.
std::optional<double> windows_propagated(const std::string& solver) {
  double windows = 0;
  for (const TriangleSoup& soup : {rough_terrain(1, 24, 24, 1.0), rough_sphere(1, 3, 0.2)}) {
    Recording recording;
    try {
      solve_once(solver, Mesh(soup), query_from({0}), &recording);
    } catch (const std::invalid_argument&) {
      return {};
    }
    if (!recording.window_propagations) return {};
    windows += static_cast<double>(*recording.window_propagations);
  }
  return windows;
}

/// What a solver does that is not wrong but useless: windows taken far out of order, or kept where
/// others beat them, cost time only. @return empty if it propagates few more than its family
std::string waste_of(const Description& solver) {
  constexpr double kMostWindows = 2;  // times those of another exact solver of its family
  const std::optional<double> own = windows_propagated(solver.name);
  if (!own) return {};
  for (const Description* other : registered_solvers()) {
    if (other == &solver || other->family != solver.family ||
        other->exactness != solver.exactness || other->independent_oracle) {
      continue;
    }
    const std::optional<double> theirs = windows_propagated(other->name);
    if (!theirs || *own <= kMostWindows * *theirs) continue;
    return solver.name + " propagates " + significant(*own / *theirs, 3) +
           " times the windows of " + other->name +
           ", of the same family: right, but does it take windows in the order of " +
           "distance, and drop those that are beaten?";
  }
  return {};
}

std::filesystem::path failure_folder(const VerifyRequest& request) {
  if (!request.out.empty()) return request.out;
  return request.random ? "failures" : "failures-" + as_file_name(request.solvers.front());
}

class Verification {
 public:
  explicit Verification(const VerifyRequest& request)
      : request_(request),
        check_(solver_named(request.solvers.front()), request.vectors, request.time_limit),
        report_(failure_folder(request), request.shrink) {}

  bool run() {
    const std::vector<MeshEntry> meshes = meshes_of(request_);
    if (request_.property.empty()) {
      for (const Property& property : all_properties()) check(property);
    } else if (meshes.empty()) {
      check(property_named(request_.property));
    }
    const std::string_view name =
        request_.property.empty() ? kDistancesProperty : std::string_view(request_.property);
    const Property& property = property_named(name);
    for (const MeshEntry& mesh : meshes) check(property, mesh);
    for (const FailedProperty& failed : failed_) report_.show(check_, failed);
    summarise();
    if (name == kDistancesProperty && count_.failed == 0) {
      if (const std::string waste = waste_of(check_.solver()); !waste.empty()) {
        std::cout << "warning: " << waste << '\n';
      }
    }
    return verdict();
  }

  bool run_on(const SavedCase& saved) {
    const Property& property = property_named(saved.property);
    const CheckResult result = check_.on_case(property, saved.given, kInfinity, true);
    report(property, property.name + " on " + saved.given.mesh, result);
    for (const std::string& line : result.explanation) std::cout << "  " << line << '\n';
    return verdict();
  }

 private:
  bool verdict() const {
    if (count_.failed == 0 && count_.not_known > 0) {
      throw HarnessError(std::to_string(count_.not_known) + " not known, as listed above");
    }
    return count_.failed == 0;
  }

  void check(const Property& property) {
    if (given_up()) return;
    const CheckResult result = check_.on_own_cases(property);
    report(property, property.name, result);
    if (!result.failed()) return;
    keep({&property, property.name, true, property.cases().at(result.at_case), result});
  }

  void check(const Property& property, const MeshEntry& entry) {
    if (given_up()) return;
    const std::string name = property.name + " on " + entry.name;
    if (!entry.available()) {
      ++count_.not_known;
      return print_line("not known", name, how_to_get(entry));
    }
    Case given = case_of(request_, entry);
    const CheckResult result = check_.on_case(property, given);
    report(property, name, result);
    if (result.failed()) keep({&property, name, false, std::move(given), result});
  }

  // A solver that never ends would take the time limit for every property.
  bool given_up() {
    const bool give_up = count_.timed_out >= kMostTimedOut;
    if (give_up) ++count_.not_checked;
    return give_up;
  }

  void report(const Property& property, const std::string& name, const CheckResult& result) {
    switch (result.outcome) {
      case CheckOutcome::holds:
        ++count_.hold;
        return print_line("holds", name, "");
      case CheckOutcome::not_claimed:
        ++count_.not_claimed;
        return print_line("not promised", name, check_.solver().name + ' ' + result.what);
      case CheckOutcome::not_known:
        ++count_.not_known;
        return print_line("not known", name, result.what);
      default:
        if (result.outcome == CheckOutcome::timed_out) ++count_.timed_out;
        ++count_.failed;
        print_line("FAILS", name, property.statement);
        print_line("", "  " + result.what, "");
    }
  }

  void keep(FailedProperty failed) {
    if (failed_.size() < kShown) failed_.push_back(std::move(failed));
  }

  void summarise() const {
    std::cout << '\n'
              << check_.solver().name << ": " << count_.hold << " hold, " << count_.failed
              << " fail, " << count_.not_claimed << " not promised, " << count_.not_known
              << " not known\n";
    if (count_.not_checked > 0) {
      std::cout << count_.not_checked << " not checked, after " << count_.timed_out
                << " did not end (--property NAME checks one, --time-limit gives more time)\n";
    }
    if (count_.failed > static_cast<int>(failed_.size())) {
      std::cout << count_.failed << " of " << count_.hold + count_.failed << " fail; begin with "
                << failed_.front().name << " (--property NAME explains another one)\n";
    }
  }

  const VerifyRequest& request_;
  const IsolatedCheck check_;
  FailureReport report_;
  std::vector<FailedProperty> failed_;  // the first ones
  struct {
    int hold = 0, failed = 0, not_claimed = 0, not_known = 0, timed_out = 0, not_checked = 0;
  } count_;
};

// The solvers named, or all that promise an accuracy and are not independent oracles.
std::vector<const Description*> solvers_of(const VerifyRequest& request) {
  std::vector<const Description*> chosen = solvers_named(request.solvers);
  if (!chosen.empty()) return chosen;
  for (const Description* solver : registered_solvers()) {
    const bool promises = solver->exactness != Exactness::unbounded;
    if (promises && !solver->independent_oracle) chosen.push_back(solver);
  }
  return chosen;
}

class RandomVerification {
 public:
  explicit RandomVerification(const VerifyRequest& request)
      : request_(request), meshes_(*request.random) {}

  bool run() {
    const std::vector<const Description*> solvers = solvers_of(request_);
    RandomTally tally;
    try {
      check_on_random_meshes(
          solvers, meshes_, request_.vectors, request_.time_limit,
          [this](RandomFailure failure) { note(std::move(failure)); }, tally);
    } catch (const Interrupted&) {
      summarise(tally);
      throw;
    }
    FailureReport report(failure_folder(request_), request_.shrink);
    for (const auto& [solver, failures] : failed_) show(report, failures.front());
    summarise(tally);
    if (!failed_.empty()) return false;
    for (const auto& [solver, of] : tally.solvers) {
      if (of.not_known > 0) throw HarnessError("some are not known, as counted above");
    }
    return true;
  }

 private:
  void note(RandomFailure failure) {
    std::vector<RandomFailure>& failures = failed_[failure.solver->name];
    if (failures.size() == kShown) return;
    print_line("FAILS",
               failure.solver->name + ": " + failure.property->name + " on " + name_of(failure),
               failure.result.what);
    failures.push_back(std::move(failure));
  }

  std::string name_of(const RandomFailure& failure) const {
    return "mesh " + std::to_string(failure.mesh) + " of seed " + std::to_string(meshes_.seed);
  }

  void show(FailureReport& report, const RandomFailure& failure) const {
    const ScratchFolder scratch;
    Case given = random_mesh_case({meshes_.seed, failure.mesh}, scratch.path());
    const std::string recipe = given.mesh;
    given.mesh = name_of(failure);
    const IsolatedCheck check(*failure.solver, request_.vectors, request_.time_limit);
    report.show(check, {failure.property, failure.solver->name + ": " + failure.property->name,
                        false, std::move(given), failure.result});
    std::cout << "  the whole      "
              << as_command_line({"verify", "--solver", failure.solver->name, "--random", "1",
                                  "--seed", std::to_string(meshes_.seed), "--first",
                                  std::to_string(failure.mesh)})
              << ": " << recipe << '\n';
  }

  void summarise(const RandomTally& tally) const {
    const auto checked = std::accumulate(tally.meshes.begin(), tally.meshes.end(), 0ULL);
    std::cout << '\n'
              << (checked < meshes_.count ? std::to_string(checked) + " of the meshes " : "meshes ")
              << meshes_.first << " to " << meshes_.first + meshes_.count - 1 << " of seed "
              << meshes_.seed << ':';
    for (std::size_t kind = 0; kind < kMeshKinds; ++kind) {
      std::cout << (kind > 0 ? ", " : " ") << tally.meshes[kind] << ' '
                << geodesic::name_of(static_cast<MeshKind>(kind));
    }
    std::cout << '\n';
    for (const auto& [solver, of] : tally.solvers) {
      std::cout << solver << ": " << of.hold << " hold, " << of.failed << " fail, " << of.not_known
                << " not known";
      if (of.not_checked > 0) {
        std::cout << ", " << of.not_checked << " not checked after " << kMostTimedOut
                  << " that did not end";
      }
      if (find_solver(solver)->exactness == Exactness::exact) {
        std::cout << "; largest relative error";
        for (std::size_t kind = 0; kind < kMeshKinds; ++kind) {
          if (tally.meshes[kind] == 0) continue;
          std::cout << ' ' << significant(of.largest_error[kind], 2) << ' '
                    << geodesic::name_of(static_cast<MeshKind>(kind));
        }
      }
      std::cout << '\n';
    }
  }

  const VerifyRequest& request_;
  const RandomMeshes& meshes_;
  std::map<std::string, std::vector<RandomFailure>> failed_;  // the first ones of each solver
};

}  // namespace

bool verify_solver(const VerifyRequest& request) {
  if (!request.file.empty()) {
    const SavedCase saved = read_case(request.file);
    VerifyRequest of_case = request;
    of_case.solvers = {saved.solver};
    of_case.vectors = saved.vectors;
    return Verification(of_case).run_on(saved);
  }
  return request.random ? RandomVerification(request).run() : Verification(request).run();
}

}  // namespace geodesic::harness
