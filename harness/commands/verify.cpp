#include "harness/commands/verify.h"

#include <cctype>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "harness/conformance/smallest.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/corpus/vectors.h"
#include "harness/error.h"
#include "harness/meshes/read.h"

namespace geodesic::harness {
namespace {

using conformance::Case;
using conformance::Examiner;
using conformance::Outcome;
using conformance::Property;
using conformance::Report;

constexpr int kSources = 3;         // a mesh
constexpr std::uint64_t kSeed = 1;  // of their choice
constexpr std::size_t kShown = 3;   // failures that are shrunk and explained
constexpr int kTimedOut = 3;        // properties, after which no more are asked

struct VerifyFlags {
  std::string solver, property, corpus, out;
  std::vector<std::string> meshes, sources;
  bool list = false, each = false;
  double limit = kInfinity, time_limit = 60, shrink = 20;
  std::string vectors = kAutoVectors;
  std::string manifest = default_manifest().string();
};

const Property& property_named(const std::string& name) {
  if (const Property* property = conformance::find_property(name)) return *property;
  std::vector<std::string> known;
  for (const Property& property : conformance::all_properties()) known.push_back(property.name);
  throw HarnessError(unknown_name("property", name, known));
}

void list_properties() {
  for (const Property& property : conformance::all_properties()) {
    std::cout << property.name << "\n    " << property.statement;
    std::vector<std::string> needs;
    for (const conformance::Claim& claim : property.needs) needs.emplace_back(claim.words);
    if (!needs.empty()) std::cout << " (needs " << join(needs) << ')';
    if (!property.on_any_mesh) std::cout << " (on its own meshes only)";
    std::cout << '\n';
  }
}

// "12" or "12:0.5", a vertex and its initial distance.
Source source_of(const std::string& word) {
  Source source;
  const char* end = word.data() + word.size();
  auto [at, error] = std::from_chars(word.data(), end, source.vertex);
  if (error == std::errc() && at != end && *at == ':') {
    const auto distance = std::from_chars(at + 1, end, source.distance);
    at = distance.ptr;
    error = distance.ec;
  }
  if (error != std::errc() || at != end) {
    throw HarnessError("--source " + word +
                       ": not a vertex, nor a vertex and its initial distance like 12:0.5");
  }
  return source;
}

std::vector<Query> queries_of(const VerifyFlags& flags, const MeshEntry& entry,
                              const TriangleSoup& soup) {
  std::vector<Source> sources;
  for (const std::string& word : flags.sources) sources.push_back(source_of(word));
  bool each = flags.each;
  if (sources.empty()) {
    each = true;
    for (const Index v : choose_sources(soup, entry.name, kSources, kSeed)) sources.push_back({v});
  }
  for (const Source& source : sources) {
    if (source.vertex < soup.positions.size()) continue;
    throw HarnessError("source vertex " + std::to_string(source.vertex) + " is not in '" +
                       entry.name + "', which has " + std::to_string(soup.positions.size()) +
                       " vertices");
  }
  if (!each) return {{.sources = sources, .limit = flags.limit}};
  std::vector<Query> queries;
  for (const Source& source : sources) {
    queries.push_back({.sources = {source}, .limit = flags.limit});
  }
  return queries;
}

Case case_of(const VerifyFlags& flags, const MeshEntry& entry) {
  TriangleSoup soup = read_mesh(entry.file).soup;
  try {
    const Mesh buildable(soup);
  } catch (const std::invalid_argument& error) {
    throw HarnessError(entry.file.string() + ": " + error.what() +
                       " (geodesic-bench mesh lists the defects of a file)");
  }
  const std::vector<Query> queries = queries_of(flags, entry, soup);
  return {.mesh = entry.name, .soup = std::move(soup), .queries = queries};
}

std::vector<MeshEntry> meshes_of(const VerifyFlags& flags) {
  std::vector<MeshEntry> entries;
  if (!flags.corpus.empty()) {
    entries = Manifest(flags.manifest, dataset_cache()).corpus(flags.corpus);
  }
  for (const std::string& mesh : flags.meshes) entries.push_back(find_mesh(mesh, flags.manifest));
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
  explicit Verification(const VerifyFlags& flags)
      : flags_(flags),
        examiner_(solver_named(flags.solver), flags.vectors, flags.time_limit),
        folder_(flags.out.empty() ? "failures-" + flags.solver : flags.out) {}

  /// @return whether all holds
  /// @throws HarnessError when nothing fails, but something could not be examined
  bool run() {
    const std::vector<MeshEntry> meshes = meshes_of(flags_);
    if (flags_.property.empty()) {
      for (const Property& property : conformance::all_properties()) examine(property);
    } else if (meshes.empty()) {
      examine(property_named(flags_.property));
    }
    const Property& asked =
        property_named(flags_.property.empty() ? conformance::kDistancesProperty : flags_.property);
    for (const MeshEntry& mesh : meshes) examine(asked, mesh);
    for (const Failed& failed : failed_) show(failed);
    summarise();
    if (!failed_.empty()) return false;
    if (unknown_ > 0) throw HarnessError(std::to_string(unknown_) + " not known, as said above");
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

  void examine(const Property& property, const MeshEntry& entry) {
    if (given_up()) return;
    const std::string name = property.name + " on " + entry.name;
    if (!entry.available()) {
      ++unknown_;
      return say("not known", name, how_to_get(entry));
    }
    Case given = case_of(flags_, entry);
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
    if (flags_.shrink > 0) {
      save(failed);
    } else if (failed.report.outcome == Outcome::wrong && !failed.given.soup.triangles.empty()) {
      show_lines(examiner_.explain(*failed.property, failed.given).explanation);
    }
  }

  void save(const Failed& failed) {
    const std::filesystem::path file = unused_file(failed);
    const conformance::Smallest smallest = conformance::save_smallest(
        examiner_, *failed.property, failed.given, failed.report, failed.own, file, flags_.shrink);
    const TriangleSoup &all = failed.given.soup, &few = smallest.given.soup;
    if (!smallest.file.empty()) {
      std::cout << "  smallest case  " << smallest.file.string() << ": " << few.positions.size()
                << " vertices and " << few.triangles.size() << " faces of the "
                << all.positions.size() << " and " << all.triangles.size() << " of '"
                << failed.given.mesh << "'\n";
    }
    std::cout << "  fails there    " << smallest.report.what << '\n'
              << "  reproduce it   " << conformance::as_command_line(smallest.command) << '\n';
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

  const VerifyFlags& flags_;
  const Examiner examiner_;
  const std::filesystem::path folder_;
  std::vector<Failed> failed_;  // the first ones
  std::set<std::filesystem::path> written_;
  std::size_t fail_ = 0;
  int hold_ = 0, unclaimed_ = 0, unknown_ = 0, timed_out_ = 0, not_asked_ = 0;
};

void check_flags(const VerifyFlags& flags) {
  if (flags.solver.empty()) throw HarnessError("--solver is required (geodesic-bench list)");
  instruction_set_named(flags.vectors);
  const bool on_meshes = !flags.meshes.empty() || !flags.corpus.empty();
  if (!on_meshes && (!flags.sources.empty() || flags.limit < kInfinity)) {
    throw HarnessError("--source and --limit are for --meshes: properties have their own");
  }
  if (!flags.property.empty() && on_meshes && !property_named(flags.property).on_any_mesh) {
    throw HarnessError("property '" + flags.property +
                       "' says something about its own meshes only: leave --meshes and --corpus "
                       "out");
  }
  if (std::filesystem::exists(flags.out) && !std::filesystem::is_directory(flags.out)) {
    throw HarnessError("--out '" + flags.out + "' is a file, and not a folder for failing meshes");
  }
}

void run_verify(const VerifyFlags& flags) {
  if (flags.list) return list_properties();
  check_flags(flags);
  if (!Verification(flags).run()) throw CLI::RuntimeError(2);
}

}  // namespace

void add_verify_command(CLI::App& app) {
  const auto flags = std::make_shared<VerifyFlags>();
  CLI::App* command =
      app.add_subcommand("verify", "Which properties of exact solvers hold, and what breaks one");
  command->add_option("--solver", flags->solver, "its name (geodesic-bench list)");
  command->add_option("--property", flags->property, "only this one");
  command->add_flag("--list", flags->list, "the properties and what they say");
  command->add_option("--corpus", flags->corpus, "also the distances on its meshes");
  command
      ->add_option("--meshes", flags->meshes,
                   "also the distances on these, names or files separated by commas; with "
                   "--property, that property on them alone")
      ->delimiter(',');
  command
      ->add_option("--source", flags->sources,
                   "on --meshes: a vertex, with its initial distance if any, like 12:0.5")
      ->allow_extra_args(false);
  command->add_flag("--each", flags->each, "solve from each source by itself, in this order");
  command->add_option("--limit", flags->limit, "on --meshes: a distance limit")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--time-limit", flags->time_limit, "seconds that a property may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--shrink", flags->shrink,
                   "seconds to spend on making a failing mesh smaller; 0 saves none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--out", flags->out, "folder for failing meshes (failures-<solver>)");
  command->add_option("--vectors", flags->vectors,
                      "instructions to solve with: auto, plain or avx2");
  command->add_option("--manifest", flags->manifest, "list of meshes and corpora");
  command->callback([flags] { run_verify(*flags); });
}

void add_examine_command(CLI::App& app) {
  const auto spec = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("examine", "")->group("");
  command->add_option("spec", *spec)->required();
  command->callback([spec] {
    conformance::run_examination(Json::parse(*spec).get<conformance::ExaminationSpec>());
  });
}

}  // namespace geodesic::harness
