#include "harness/verify/verification.h"

#include <cctype>
#include <iostream>
#include <set>

#include "harness/base/error.h"
#include "harness/base/plugins.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/verify/smallest.h"
#include "meshes/mesh_file.h"

namespace geodesic::conformance {
namespace {

constexpr int kSources = 3;         // a mesh
constexpr std::uint64_t kSeed = 1;  // of their choice
constexpr std::size_t kShown = 3;   // failures that are shrunk and explained
constexpr int kTimedOut = 3;        // properties, after which no more are asked

std::vector<Query> queries_of(const VerifyRequest& request, const harness::MeshEntry& entry,
                              const TriangleSoup& soup) {
  std::vector<Source> sources = request.sources;
  bool each = request.each;
  if (sources.empty()) {
    each = true;
    for (const Index v : harness::choose_sources(soup, entry.name, kSources, kSeed))
      sources.push_back({v});
  }
  for (const Source& source : sources) {
    if (source.vertex < soup.positions.size()) continue;
    throw harness::HarnessError("source vertex " + std::to_string(source.vertex) + " is not in '" +
                                entry.name + "', which has " +
                                std::to_string(soup.positions.size()) + " vertices");
  }
  if (!each) return {{.sources = sources, .limit = request.limit}};
  std::vector<Query> queries;
  for (const Source& source : sources) {
    queries.push_back({.sources = {source}, .limit = request.limit});
  }
  return queries;
}

Case case_of(const VerifyRequest& request, const harness::MeshEntry& entry) {
  TriangleSoup soup = read_mesh(entry.file).soup;
  try {
    const Mesh buildable(soup);
  } catch (const std::invalid_argument& error) {
    throw harness::HarnessError(entry.file.string() + ": " + error.what() +
                                " (geodesic-bench mesh lists the defects of a file)");
  }
  const std::vector<Query> queries = queries_of(request, entry, soup);
  return {.mesh = entry.name, .soup = std::move(soup), .queries = queries};
}

std::vector<harness::MeshEntry> meshes_of(const VerifyRequest& request) {
  std::vector<harness::MeshEntry> entries;
  if (!request.corpus.empty()) {
    entries = harness::Manifest(request.manifest, harness::dataset_cache()).corpus(request.corpus);
  }
  for (const std::string& mesh : request.meshes)
    entries.push_back(harness::find_mesh(mesh, request.manifest));
  return entries;
}

// "distances-equal-the-reference-on-hill"
std::string file_stem(const std::string& property, const std::string& mesh) {
  std::string stem = property + "-on-" + mesh;
  for (char& c : stem) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_';
    if (!plain) c = '-';
  }
  return stem;
}

class Verification {
 public:
  explicit Verification(const VerifyRequest& request)
      : request_(request),
        examiner_(harness::solver_named(request.solver), request.vectors, request.time_limit),
        folder_(request.out.empty() ? std::filesystem::path("failures-" + request.solver)
                                    : request.out) {}

  /// @return whether all holds
  /// @throws harness::HarnessError when nothing fails, but something could not be examined
  bool run() {
    const std::vector<harness::MeshEntry> meshes = meshes_of(request_);
    if (request_.property.empty()) {
      for (const Property& property : all_properties()) examine(property);
    } else if (meshes.empty()) {
      examine(property_named(request_.property));
    }
    const Property& asked =
        property_named(request_.property.empty() ? kDistancesProperty : request_.property);
    for (const harness::MeshEntry& mesh : meshes) examine(asked, mesh);
    for (const Failed& failed : failed_) show(failed);
    summarise();
    if (!failed_.empty()) return false;
    if (unknown_ > 0)
      throw harness::HarnessError(std::to_string(unknown_) + " not known, as said above");
    return true;
  }

 private:
  struct Failed {
    const Property* property;
    std::string name;  // of the property, with the mesh if it is a user's
    bool own;          // whether it failed on the property's own cases
    Case given;
    Report report;
  };

  void examine(const Property& property) {
    if (given_up()) return;
    const Report report = examiner_.examine(property);
    note(property, report, property.name);
    if (!report.failed()) return;
    keep({&property, property.name, true, property.cases().at(report.at_case), report});
  }

  void examine(const Property& property, const harness::MeshEntry& entry) {
    if (given_up()) return;
    const std::string name = property.name + " on " + entry.name;
    if (!entry.available()) {
      ++unknown_;
      return say("not known", name, harness::how_to_get(entry));
    }
    Case given = case_of(request_, entry);
    const Report report = examiner_.examine_file(property, entry.file, given.queries);
    note(property, report, name);
    if (report.failed()) keep({&property, name, false, std::move(given), report});
  }

  // A solver that never ends would take the time limit for every property.
  bool given_up() {
    const bool give_up = timed_out_ >= kTimedOut;
    if (give_up) ++not_asked_;
    return give_up;
  }

  void keep(Failed failed) {
    if (failed.report.outcome == Outcome::timed_out) ++timed_out_;
    ++fail_;
    if (failed_.size() < kShown) failed_.push_back(std::move(failed));
  }

  static void say(const std::string& outcome, const std::string& name, const std::string& why) {
    constexpr std::size_t kColumn = 13;
    std::cout << "  " << outcome << std::string(kColumn - outcome.size(), ' ') << name << '\n';
    if (!why.empty()) std::cout << std::string(kColumn + 4, ' ') << why << '\n';
    std::cout.flush();
  }

  void note(const Property& property, const Report& report, const std::string& name) {
    switch (report.outcome) {
      case Outcome::holds:
        ++hold_;
        return say("holds", name, "");
      case Outcome::unclaimed:
        ++unclaimed_;
        return say("not claimed", name, examiner_.solver().name + ' ' + report.what);
      case Outcome::unjudged:
        ++unknown_;
        return say("not known", name, report.what);
      default:
        say("FAILS", name, property.statement);
        say("", "  " + report.what, "");
    }
  }

  void show(const Failed& failed) {
    std::cout << '\n' << failed.name << '\n';
    if (request_.shrink > 0) {
      save(failed);
    } else if (failed.report.outcome == Outcome::wrong && !failed.given.soup.triangles.empty()) {
      show_lines(examiner_.explain(*failed.property, failed.given).explanation);
    }
  }

  void save(const Failed& failed) {
    const std::filesystem::path file = unused_file(failed);
    const Smallest smallest = save_smallest(examiner_, *failed.property, failed.given,
                                            failed.report, failed.own, file, request_.shrink);
    const TriangleSoup &all = failed.given.soup, &few = smallest.given.soup;
    if (!smallest.file.empty()) {
      std::cout << "  smallest case  " << smallest.file.string() << ": " << few.positions.size()
                << " vertices and " << few.triangles.size() << " faces of the "
                << all.positions.size() << " and " << all.triangles.size() << " of '"
                << failed.given.mesh << "'\n";
    }
    std::cout << "  fails there    " << smallest.report.what << '\n'
              << "  reproduce it   " << harness::as_command_line(smallest.command) << '\n';
    if (!smallest.repeated) {
      std::cout
          << "                 (when tried, it did not fail again: the answer may change from "
             "one solve to the next)\n";
    }
    show_lines(smallest.report.explanation);
  }

  // Meshes of different folders may have one name; what an earlier run left is written over.
  std::filesystem::path unused_file(const Failed& failed) {
    const std::string stem = file_stem(failed.property->name, failed.given.mesh);
    std::filesystem::path file = folder_ / (stem + ".obj");
    for (int i = 2; !written_.insert(file).second; ++i) {
      file = folder_ / (stem + '-' + std::to_string(i) + ".obj");
    }
    return file;
  }

  static void show_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) std::cout << "  " << line << '\n';
    std::cout.flush();
  }

  void summarise() const {
    std::cout << '\n'
              << examiner_.solver().name << ": " << hold_ << " hold, " << fail_ << " fail, "
              << unclaimed_ << " not claimed, " << unknown_ << " not known\n";
    if (not_asked_ > 0) {
      std::cout << not_asked_ << " not asked, after " << timed_out_
                << " did not end (--property NAME asks one, --time-limit gives more time)\n";
    }
    if (fail_ > failed_.size()) {
      std::cout << "the first " << failed_.size()
                << " that fail are shown (--property NAME shows one)\n";
    }
  }

  const VerifyRequest& request_;
  const Examiner examiner_;
  const std::filesystem::path folder_;
  std::vector<Failed> failed_;  // the first ones
  std::set<std::filesystem::path> written_;
  std::size_t fail_ = 0;
  int hold_ = 0, unclaimed_ = 0, unknown_ = 0, timed_out_ = 0, not_asked_ = 0;
};

}  // namespace

const Property& property_named(const std::string& name) {
  if (const Property* property = find_property(name)) return *property;
  std::vector<std::string> known;
  for (const Property& property : all_properties()) known.push_back(property.name);
  throw harness::HarnessError(unknown_name("property", name, known));
}

bool verify_solver(const VerifyRequest& request) { return Verification(request).run(); }

}  // namespace geodesic::conformance
