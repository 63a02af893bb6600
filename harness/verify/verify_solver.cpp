#include "harness/verify/verify_solver.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <set>
#include <string_view>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/verify/reproduce.h"
#include "meshes/mesh_file.h"

namespace geodesic::harness {
namespace {

constexpr int kSources = 3;         // a mesh
constexpr std::uint64_t kSeed = 1;  // of their choice
constexpr std::size_t kShown = 3;   // failures that are shrunk and explained
constexpr int kTimedOut = 3;        // properties, after which no more are checked

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
  for (const std::string& mesh : request.meshes)
    entries.push_back(find_mesh(mesh, request.manifest));
  return entries;
}

// "distances-equal-the-reference-on-hill"
std::string file_stem(const std::string& property, const std::string& mesh) {
  std::string stem = property + "-on-" + mesh;
  std::ranges::replace_if(stem, std::not_fn(is_plain), '-');
  return stem;
}

void print_line(const std::string& outcome, const std::string& name, const std::string& why) {
  constexpr std::size_t kColumn = 13;
  std::cout << "  " << outcome << std::string(kColumn - outcome.size(), ' ') << name << '\n';
  if (!why.empty()) std::cout << std::string(kColumn + 4, ' ') << why << '\n';
  std::cout.flush();
}

void print_explanation(const CheckResult& result) {
  for (const std::string& line : result.explanation) std::cout << "  " << line << '\n';
  std::cout.flush();
}

class Verification {
 public:
  explicit Verification(const VerifyRequest& request)
      : request_(request),
        check_(solver_named(request.solver), request.vectors, request.time_limit),
        folder_(request.out.empty()
                    ? std::filesystem::path("failures-" + as_file_name(check_.solver().name))
                    : request.out) {}

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
    for (const FailedProperty& failed : failed_) show(failed);
    summarise();
    const int failures = count_.failed;
    if (failures == 0 && count_.not_known > 0)
      throw HarnessError(std::to_string(count_.not_known) + " not known, as listed above");
    return failures == 0;
  }

 private:
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
    const bool give_up = count_.timed_out >= kTimedOut;
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
        return print_line("not claimed", name, check_.solver().name + ' ' + result.what);
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

  void show(const FailedProperty& failed) {
    std::cout << '\n' << failed.name << '\n';
    if (request_.shrink > 0) {
      save(failed);
    } else if (failed.result.outcome == CheckOutcome::wrong &&
               !failed.given.soup.triangles.empty()) {
      print_explanation(check_.on_case(*failed.property, failed.given, kInfinity, true));
    }
  }

  void save(const FailedProperty& failed) {
    const Reproduction saved = save_smallest(check_, failed, unused_file(failed), request_.shrink);
    const TriangleSoup &all = failed.given.soup, &few = saved.given.soup;
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

  // Meshes of different folders may have one name; what an earlier call left is overwritten.
  std::filesystem::path unused_file(const FailedProperty& failed) {
    const std::string stem = file_stem(failed.property->name, failed.given.mesh);
    std::filesystem::path file = folder_ / (stem + ".obj");
    for (int i = 2; !written_.insert(file).second; ++i) {
      file = folder_ / (stem + '-' + std::to_string(i) + ".obj");
    }
    return file;
  }

  void summarise() const {
    std::cout << '\n'
              << check_.solver().name << ": " << count_.hold << " hold, " << count_.failed
              << " fail, " << count_.not_claimed << " not claimed, " << count_.not_known
              << " not known\n";
    if (count_.not_checked > 0) {
      std::cout << count_.not_checked << " not checked, after " << count_.timed_out
                << " did not end (--property NAME checks one, --time-limit gives more time)\n";
    }
    if (count_.failed > static_cast<int>(failed_.size())) {
      std::cout << "the first " << failed_.size()
                << " that fail are shown (--property NAME shows one)\n";
    }
  }

  const VerifyRequest& request_;
  const IsolatedCheck check_;
  const std::filesystem::path folder_;
  std::vector<FailedProperty> failed_;  // the first ones
  std::set<std::filesystem::path> written_;
  struct {
    int hold = 0, failed = 0, not_claimed = 0, not_known = 0, timed_out = 0, not_checked = 0;
  } count_;
};

}  // namespace

bool verify_solver(const VerifyRequest& request) { return Verification(request).run(); }

}  // namespace geodesic::harness
