#include "harness/commands/commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/results/context.h"
#include "harness/results/text_table.h"
#include "harness/verify/references.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

struct ListFlags {
  std::string corpus;
  bool json = false;
  std::string manifest = default_manifest().string();
};

TextTable solver_table() {
  TextTable table{{"solver", "family", "distances", "runs", "paper"}};
  for (const Description* solver : registered_solvers()) {
    table.push_back({solver->name, solver->family, shown_exactness(*solver),
                     solver->by_name_only ? "when named" : "always", solver->paper});
  }
  return table;
}

constexpr const char* kHowToSet =
    "  A parameter is set in the solver's name, to several values for as many solvers, as in "
    "--solvers 'SOLVER?PARAMETER=1,2,4'.\n";

// The parameters of all solvers that have any.
TextTable parameter_table() {
  TextTable table{{"solver", "parameter", "default", "what it is", "must be"}};
  for (const Description* solver : registered_solvers()) {
    for (const ParameterDescription& parameter : solver->parameters) {
      table.push_back({solver->name, parameter.name, parameter.default_value.text(),
                       parameter.description, parameter.range()});
    }
  }
  return table;
}

std::vector<std::string> corpora_with(const Manifest& manifest, const std::string& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, members] : manifest.corpora()) {
    if (std::count(members.begin(), members.end(), mesh) > 0) names.push_back(name);
  }
  return names;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

TextTable mesh_table(const Manifest& manifest, const std::vector<MeshEntry>& meshes) {
  TextTable table{
      {"mesh", "vertices", "faces", "kind", "corpora", "distances known", "in the cache"}};
  for (const MeshEntry& mesh : meshes) {
    table.push_back({mesh.name, std::to_string(mesh.vertices), std::to_string(mesh.faces),
                     mesh.kind, join(corpora_with(manifest, mesh.name)),
                     yes_or_no(has_closed_form(mesh)), yes_or_no(mesh.available())});
  }
  return table;
}

// The manifest's meshes and what they are made from, with facts of this machine, and the solvers.
Json to_json(const Manifest& manifest, const std::vector<MeshEntry>& meshes) {
  Json json{{"solvers", Json::array()},
            {"sources", manifest.json()["sources"]},
            {"corpora", manifest.json()["corpora"]},
            {"meshes", Json::array()},
            {"elevation_grids", manifest.json()["elevation_grids"]}};
  for (const Description* solver : registered_solvers()) {
    json["solvers"].push_back(describe(*solver));
  }
  for (const MeshEntry& mesh : meshes) {
    const Json& entries = manifest.json()["meshes"];
    Json entry =
        *std::ranges::find_if(entries, [&](const Json& each) { return each["name"] == mesh.name; });
    entry.update({{"thesis_model", mesh.thesis_model},
                  {"stand_in", mesh.stand_in},
                  {"corpora", corpora_with(manifest, mesh.name)},
                  {"distances_known", has_closed_form(mesh)},
                  {"cached", mesh.available()}});
    json["meshes"].push_back(entry);
  }
  return json;
}

void run_list(const ListFlags& flags) {
  const Manifest manifest(flags.manifest, dataset_cache());
  const std::vector<MeshEntry> meshes =
      flags.corpus.empty() ? manifest.meshes() : manifest.corpus(flags.corpus);
  if (flags.json) {
    std::cout << to_json(manifest, meshes).dump(2) << '\n';
    return;
  }
  const TextTable parameters = parameter_table();
  std::cout << as_text(solver_table()) << '\n';
  if (parameters.size() > 1) std::cout << as_text(parameters) << '\n' << kHowToSet << '\n';
  std::cout << as_text(mesh_table(manifest, meshes));
}

}  // namespace

void add_list_command(CLI::App& app) {
  const auto flags = std::make_shared<ListFlags>();
  CLI::App* command = app.add_subcommand("list", "List the solvers and meshes");
  command->add_option("--corpus", flags->corpus, "list the meshes of this corpus only")
      ->type_name("NAME");
  command->add_flag("--json", flags->json, "print everything as a JSON object");
  command->add_option("--manifest", flags->manifest, "list of meshes and corpora")
      ->type_name("FILE");
  command->footer(
      "\nExamples:\n  geodesic-bench list --corpus quick\n  geodesic-bench list --json");
  command->callback([flags] { run_list(*flags); });
}

}  // namespace geodesic::harness
