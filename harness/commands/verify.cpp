#include "harness/commands/commands.h"

#include <filesystem>
#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/points.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/check_process.h"
#include "harness/verify/verify_solver.h"

namespace geodesic::harness {
namespace {

struct VerifyFlags {
  VerifyRequest request;
  RandomMeshes random;
  std::vector<std::string> sources;
  bool list = false;
};

void list_properties() {
  for (const Property& property : all_properties()) {
    std::cout << property.name << "\n    " << property.statement;
    const std::vector<std::string> needs = needs_of(property);
    if (!needs.empty()) std::cout << " (needs " << join(needs) << ')';
    if (!property.on_any_mesh) std::cout << " (on its own meshes only)";
    std::cout << '\n';
  }
}

std::vector<Source> sources_of(const std::string& words) {
  std::vector<Source> sources;
  for (const WrittenPoint& point : parse_points(words, "--source")) {
    if (point.kind != WrittenPoint::Kind::vertex) {
      throw HarnessError(point.text + ": verify takes vertices, such as 12 or 12+0.5");
    }
    sources.push_back({.at = point.elements[0], .distance = point.initial.value_or(0)});
  }
  return sources;
}

void check_request(const VerifyRequest& request) {
  if (request.solvers.empty() && !request.random && request.file.empty()) {
    throw HarnessError("--solver is required (geodesic-bench list)");
  }
  if (request.solvers.size() > 1 && !request.random) {
    throw HarnessError("--solver: several are checked with --random only");
  }
  instruction_set_named(request.vectors);
  const bool on_meshes = !request.meshes.empty() || !request.corpus.empty();
  if (!on_meshes && (!request.sources.empty() || request.limit < kInfinity)) {
    throw HarnessError("--source and --limit need --meshes or --corpus");
  }
  if (!request.property.empty() && on_meshes && !property_named(request.property).on_any_mesh) {
    throw HarnessError("property '" + request.property +
                       "' is defined on its own meshes only: remove --meshes and --corpus");
  }
  if (std::filesystem::exists(request.out) && !std::filesystem::is_directory(request.out)) {
    throw HarnessError("--out '" + request.out.string() +
                       "' is a file: name a folder for failing meshes");
  }
}

void run_verify(const VerifyFlags& flags) {
  if (flags.list) return list_properties();
  VerifyRequest request = flags.request;
  request.meshes = expand_meshes(request.meshes);
  for (const std::string& words : flags.sources) {
    const std::vector<Source> sources = sources_of(words);
    request.sources.insert(request.sources.end(), sources.begin(), sources.end());
  }
  if (flags.random.count > 0) request.random = flags.random;
  check_request(request);
  const InterruptionGuard guard;  // on a signal, temporary files are removed
  if (!verify_solver(request)) throw CLI::RuntimeError(2);
}

}  // namespace

void add_verify_command(CLI::App& app) {
  const auto flags = std::make_shared<VerifyFlags>();
  VerifyRequest& request = flags->request;
  request.vectors = kAutoVectors;
  request.manifest = default_manifest();
  CLI::App* command = app.add_subcommand(
      "verify", "Check a solver for the properties that all solvers promise, and explain failures");
  command
      ->add_option("--solver", request.solvers,
                   "solver to check (see geodesic-bench list); with --random there may be several "
                   "(default: all with a guarantee)")
      ->delimiter(',')
      ->type_name("NAME");
  command->add_option("--property", request.property, "check this property only")
      ->type_name("NAME");
  command
      ->add_option("--file", request.file,
                   "check the case of this file again, which an earlier call saved beside its mesh")
      ->type_name("FILE")
      ->excludes("--solver")
      ->excludes("--property");
  command->add_flag("--list", flags->list, "print the properties");
  command->add_option("--corpus", request.corpus, "check the distances on this corpus as well")
      ->type_name("NAME");
  command
      ->add_option("--meshes", request.meshes,
                   "check the distances on these as well: mesh files, folders, patterns such as "
                   "'scans/*.ply', or names of the manifest; with --property, check that property "
                   "on these only")
      ->delimiter(',')
      ->type_name("NAMES");
  command
      ->add_option("--source", flags->sources,
                   "source vertex on those meshes, 0-based, repeatable; with an initial distance: "
                   "12+0.5 (default: three of each mesh)")
      ->allow_extra_args(false)
      ->type_name("V[+X]");
  command->add_flag("--each", request.each, "solve from each source separately, in this order");
  command
      ->add_option("--limit", request.limit,
                   "distance beyond which vertices of those meshes are unreachable")
      ->check(zero_or_above());
  CLI::Option* random =
      command
          ->add_option("--random", flags->random.count,
                       "check only distances and paths, on this many random meshes")
          ->check(CLI::Range(1, 100'000'000))
          ->excludes("--property")
          ->excludes("--file")
          ->excludes("--corpus")
          ->excludes("--meshes");
  command->add_option("--seed", flags->random.seed, "seed of the random meshes (default: 1)")
      ->needs(random);
  command
      ->add_option("--first", flags->random.first, "number of the first random mesh (default: 0)")
      ->needs(random);
  command
      ->add_option("--jobs", flags->random.jobs,
                   "processes at a time for random meshes (default: 1)")
      ->check(CLI::Range(1, 1000))
      ->needs(random);
  command
      ->add_option("--time-limit", request.time_limit, "seconds a property may take (default: 60)")
      ->check(above_zero());
  command
      ->add_option("--shrink", request.shrink,
                   "seconds for making a failing mesh smaller; 0 saves no mesh (default: 20)")
      ->check(zero_or_above());
  command
      ->add_option("--out", request.out, "folder for failing meshes (default: failures-<solver>)")
      ->type_name("DIR");
  command
      ->add_option("--vectors", request.vectors,
                   "instruction set of the solver: auto, plain, avx2 or avx512")
      ->type_name("SET");
  command->add_option("--manifest", request.manifest, "list of meshes and corpora")
      ->type_name("FILE");
  command->footer(
      "\nExamples:\n  geodesic-bench verify --solver my-variant\n"
      "  geodesic-bench verify --solver my-variant --property distances-are-symmetric --meshes "
      "scans/\n"
      "  geodesic-bench verify --solver my-variant --random 1000 --jobs 2");
  command->callback([flags] { run_verify(*flags); });
}

void add_check_command(CLI::App& app) {
  const auto task = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("check-cases", "")->group("");
  command->add_option("task", *task)->required();
  command->callback([task] { run_checks(*task); });
}

}  // namespace geodesic::harness
