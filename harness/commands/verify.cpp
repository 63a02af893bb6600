#include "harness/commands/commands.h"

#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/vectors.h"
#include "harness/verify/isolated_check.h"
#include "harness/verify/verify_solver.h"

namespace geodesic::harness {
namespace {

struct VerifyFlags {
  VerifyRequest request;
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

void check_request(const VerifyRequest& request) {
  if (request.solver.empty()) throw HarnessError("--solver is required (geodesic-bench list)");
  instruction_set_named(request.vectors);
  const bool on_meshes = !request.meshes.empty() || !request.corpus.empty();
  if (!on_meshes && (!request.sources.empty() || request.limit < kInfinity)) {
    throw HarnessError("--source and --limit are for --meshes: properties have their own");
  }
  if (!request.property.empty() && on_meshes && !property_named(request.property).on_any_mesh) {
    throw HarnessError("property '" + request.property +
                       "' holds on its own meshes only: leave --meshes and --corpus out");
  }
  if (std::filesystem::exists(request.out) && !std::filesystem::is_directory(request.out)) {
    throw HarnessError("--out '" + request.out.string() +
                       "' is a file, and not a folder for failing meshes");
  }
}

void run_verify(const VerifyFlags& flags) {
  if (flags.list) return list_properties();
  VerifyRequest request = flags.request;
  for (const std::string& word : flags.sources) request.sources.push_back(source_of(word));
  check_request(request);
  const InterruptionGuard guard;  // temporary files are removed
  if (!verify_solver(request)) throw CLI::RuntimeError(2);
}

}  // namespace

void add_verify_command(CLI::App& app) {
  const auto flags = std::make_shared<VerifyFlags>();
  VerifyRequest& request = flags->request;
  request.vectors = kAutoVectors;
  request.manifest = default_manifest();
  CLI::App* command =
      app.add_subcommand("verify", "Which properties of exact solvers hold, and what breaks one");
  command->add_option("--solver", request.solver, "its name (geodesic-bench list)");
  command->add_option("--property", request.property, "only this one");
  command->add_flag("--list", flags->list, "the properties and what they say");
  command->add_option("--corpus", request.corpus, "also the distances on its meshes");
  command
      ->add_option("--meshes", request.meshes,
                   "also the distances on these, names or files separated by commas; with "
                   "--property, that property on them alone")
      ->delimiter(',');
  command
      ->add_option("--source", flags->sources,
                   "on --meshes: a vertex, with its initial distance if any, like 12:0.5")
      ->allow_extra_args(false);
  command->add_flag("--each", request.each, "solve from each source by itself, in this order");
  command->add_option("--limit", request.limit, "on --meshes: a distance limit")
      ->check(zero_or_above());
  command->add_option("--time-limit", request.time_limit, "seconds that a property may take")
      ->check(above_zero())
      ->capture_default_str();
  command
      ->add_option("--shrink", request.shrink,
                   "seconds to spend on making a failing mesh smaller; 0 saves none")
      ->check(zero_or_above())
      ->capture_default_str();
  command->add_option("--out", request.out, "folder for failing meshes (failures-<solver>)");
  command->add_option("--vectors", request.vectors,
                      "instructions to solve with: auto, plain or avx2");
  command->add_option("--manifest", request.manifest, "list of meshes and corpora");
  command->callback([flags] { run_verify(*flags); });
}

void add_check_property_command(CLI::App& app) {
  const auto task = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("check-property", "")->group("");
  command->add_option("task", *task)->required();
  command->callback([task] { run_isolated_check(*task); });
}

}  // namespace geodesic::harness
