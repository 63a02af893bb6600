#include "harness/run/resume.h"

#include <dlfcn.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/base/plugins.h"
#include "harness/external/external_program.h"
#include "harness/results/context.h"
#include "harness/results/environment.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr int kVersion = 5;  // of request.json
constexpr const char* kFile = "request.json";

// Includes hashes of the binaries, because a revision does not cover later changes. Excludes the
// processor: a run may be resumed on another one (Row::processor).
Json program_identity() {
  Json program = program_context();
  program.erase("processor");
  program["executable"] = sha256_of_file("/proc/self/exe");
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&registered_solvers), &library) != 0) {
    program["solvers"] = sha256_of_file(library.dli_fname);
  }
  return program;
}

std::string sha256_of_json(const Json& json) { return sha256_of(json.dump()); }

Json identity(const RunRequest& request, const Plan& plan) {
  Json solvers = Json::array(), meshes = Json::array(), programs = Json::object();
  for (const Description* solver : plan.solvers) solvers.push_back(solver->name);
  for (const PlannedMesh& mesh : plan.meshes) {
    meshes.push_back({{"name", mesh.entry.name},
                      {"sha256", mesh.facts.at("sha256")},
                      {"sources", names_in_json(mesh.sources)}});
    for (const SourceSet& source : mesh.sources) {
      if (source.is_single()) continue;
      meshes.back()["source_sets"][source.name] = sha256_of_json(source.vertices);
    }
  }
  for (const Program& program : request.programs) {
    programs[program.name] = sha256_of_file(program.file);
  }
  return {{"program", program_identity()},
          {"programs", std::move(programs)},
          {"options", request},
          {"solvers", std::move(solvers)},
          {"meshes", std::move(meshes)}};
}

// JSON whose keys are found quickly.
using Sorted = nlohmann::json;

// All values of an identity by their paths. Meshes have their names in the paths.
Sorted values_of(const Json& identity) {
  Sorted sorted = identity;
  Sorted by_name = Sorted::object();
  for (Sorted& mesh : sorted.at("meshes")) {
    const std::string name = mesh.at("name");
    mesh.erase("name");
    by_name[name] = std::move(mesh);
  }
  sorted["meshes"] = std::move(by_name);
  return sorted.flatten();
}

// "options/seed is 2 and was 1", for every value of two identities that differs.
std::vector<std::string> differences(const Json& before, const Json& now) {
  const Sorted old_values = values_of(before), new_values = values_of(now);
  std::vector<std::string> all;
  for (const auto& [path, value] : new_values.items()) {
    const std::string was =
        old_values.contains(path) ? "was " + old_values[path].dump() : "was absent";
    if (was != "was " + value.dump()) {
      all.push_back(path.substr(1) + " is " + value.dump() + " and " + was);
    }
  }
  for (const auto& [path, value] : old_values.items()) {
    if (!new_values.contains(path)) {
      all.push_back(path.substr(1) + " is absent and was " + value.dump());
    }
  }
  return all;
}

// The rows of the cell's file. @throws std::exception with the reason when they are not valid
std::vector<Row> sound_rows(const Cell& cell, const CellSpec& spec) {
  std::vector<Row> rows = read_rows(spec.output);
  for (const Row& row : rows) {
    if (row.name() != cell.name()) throw HarnessError("is of another cell");
    if (row.recordings && !fs::exists(fs::path(spec.run_folder) / *row.recordings)) {
      throw HarnessError("has lost its recordings");
    }
  }
  const Row& first = rows.front();
  const bool complete = cell.repetition < 0
                            ? static_cast<std::size_t>(first.repetitions) == rows.size()
                            : first.repetition_index == cell.repetition;
  if (!complete) throw HarnessError("has not all its repetitions");
  if (first.program.value_or("") != (cell.program == nullptr ? "" : cell.program->name)) {
    throw HarnessError("is of another program");
  }
  return rows;
}

}  // namespace

void identify(RunRequest& request, const Plan& plan) {
  request.identity = identity(request, plan);
  request.started = utc_now();
  const Json here = environment();
  request.environments = {here};
  if (!request.resume) return;
  const RunRequest before = saved_request(*request.resume);
  request.started = before.started;
  request.changes = before.changes;
  request.command = before.command;
  request.environments = before.environments;
  if (!are_alike(before.environments.back(), here)) request.environments.push_back(here);
  const std::vector<std::string> changes = differences(before.identity, request.identity);
  if (!changes.empty() && !request.accept_changes) {
    throw HarnessError("cannot resume the run in '" + request.resume->string() +
                       "': " + join(changes, "; ") +
                       ": start a new run, or mix both results with --accept-changes");
  }
  for (const std::string& change : changes) std::cerr << "accepted: " << change << '\n';
  request.changes.insert(request.changes.end(), changes.begin(), changes.end());
}

// Leaves out paths and the memory limit, which differ between machines with the same files.
Json shard_context(const RunRequest& request, const Plan& plan) {
  Json program = request.identity.at("program"), suite = request.identity.at("options");
  for (Json& plugin : program["plugins"]) plugin.erase("file");
  program["programs"] = request.identity.at("programs");
  for (const char* key : {"shard", "manifest", "programs", "folder"}) suite.erase(key);
  for (const char* key : {"meshes", "memory_limit"}) suite["suite"].erase(key);
  suite["suite"]["solvers"] = request.identity.at("solvers");
  for (Json& set : suite["suite"]["source_sets"]) set = name_of_source_set(set);
  std::set<std::string> here;
  for (const PlannedMesh& mesh : plan.meshes) here.insert(mesh.entry.name);
  for (const SkippedMesh& mesh : plan.skipped) here.insert(mesh.name);
  Sorted places = Sorted::object(), sources = Sorted::object();
  for (std::size_t i = 0; i < plan.whole_run.size(); ++i) {
    if (here.contains(plan.whole_run[i].name)) places[plan.whole_run[i].name] = i;
  }
  for (const PlannedMesh& mesh : plan.meshes) {
    sources[mesh.entry.name] = names_in_json(mesh.run_sources);
  }
  return {{"index", request.shard->index},
          {"of", request.shard->of},
          {"suite", sha256_of_json(suite)},
          {"program", sha256_of_json(program)},
          {"meshes", sha256_of_json(plan.whole_run)},
          {"places", Json(places)},
          {"sources", Json(sources)}};
}

void save_request(const RunRequest& request, const fs::path& folder) {
  write_json(folder / kFile, {{"schema_version", kVersion},
                              {"command", request.command},
                              {"started", request.started},
                              {"changes", request.changes},
                              {"environments", request.environments},
                              {"identity", request.identity}});
}

RunRequest saved_request(const fs::path& folder) {
  const fs::path file = folder / kFile;
  if (!fs::exists(file)) {
    throw HarnessError("'" + folder.string() + "' holds no run to resume (it has no " + kFile +
                       "): give the folder of one, or start one without --resume");
  }
  const Json json = read_json(file);
  try {
    if (json.at("schema_version") != kVersion) throw HarnessError("another version wrote it");
    RunRequest request = json.at("identity").at("options");
    request.identity = json.at("identity");
    json.at("started").get_to(request.started);
    json.at("changes").get_to(request.changes);
    json.at("environments").get_to(request.environments);
    if (request.environments.empty()) throw HarnessError("it names no environment");
    json.at("command").get_to(request.command);
    request.resume = folder;
    return request;
  } catch (const std::exception& error) {
    throw HarnessError("cannot resume the run: " + file.string() + ": " + error.what());
  }
}

void load_plugins_of(const fs::path& folder) {
  const Json identity = saved_request(folder).identity;
  for (const Json& plugin : identity.at("program").at("plugins")) {
    const bool is_library = plugin.contains("file");
    const std::string value = plugin.at(is_library ? "file" : "external");
    const auto is_it = [&](const Plugin& loaded) { return loaded.value == value; };
    if (std::ranges::any_of(loaded_plugins(), is_it)) continue;
    load_by_option(is_library ? kPluginOption : kExternalOption, value);
  }
}

void remove_parts_of_files(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == kPartOfFile) fs::remove(entry.path(), ignored);
  }
}

std::optional<std::vector<Row>> kept_rows(const Cell& cell, const CellSpec& spec) {
  if (!fs::exists(spec.output)) return std::nullopt;
  try {
    return sound_rows(cell, spec);
  } catch (const std::exception& error) {
    std::cerr << spec.output << ' ' << error.what() << ": the cell is measured again\n";
    fs::remove(spec.output);
    return std::nullopt;
  }
}

}  // namespace geodesic::harness
