#include "harness/cells/request.h"

#include <dlfcn.h>

#include <map>

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/base/sha256.h"
#include "harness/results/context.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr int kVersion = 2;  // of request.json
constexpr const char* kFile = "request.json";

Json options_of(const RunRequest& request) {
  Json programs = Json::object();
  for (const auto& [name, file] : request.programs) programs[name] = file.string();
  return {{"suite", request.suite},
          {"manifest", request.manifest.string()},
          {"recordings", name_of(request.pictured)},
          {"benchmark_flags", request.benchmark_flags},
          {"interleave", request.interleave},
          {"programs", programs},
          {"cells", request.cells}};
}

// A revision does not say what was changed since, so the files count that hold the code.
Json program_identity() {
  Json program = program_context();
  program["executable"] = sha256_of_file("/proc/self/exe");
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&registered_solvers), &library) != 0) {
    program["solvers"] = sha256_of_file(library.dli_fname);
  }
  return program;
}

// By its path ("options/suite/seed") every value that is no object.
std::map<std::string, Json> values_of(const Json& json) {
  std::map<std::string, Json> values;
  const auto add = [&](const auto& self, const std::string& path, const Json& part) -> void {
    if (!part.is_object()) {
      values[path] = part;
      return;
    }
    for (const auto& [key, value] : part.items()) {
      self(self, path.empty() ? key : path + '/' + key, value);
    }
  };
  add(add, "", json);
  return values;
}

}  // namespace

Json identity(const RunRequest& request, const Plan& plan) {
  Json solvers = Json::array(), meshes = Json::object();
  for (const Description* solver : plan.solvers) solvers.push_back(solver->name);
  for (const PlannedMesh& mesh : plan.meshes) {
    meshes[mesh.entry.name] = {{"sha256", mesh.facts.at("sha256")}, {"sources", mesh.sources}};
  }
  Json programs = Json::object();
  for (const auto& [name, file] : request.programs) programs[name] = sha256_of_file(file);
  return {{"program", program_identity()},
          {"programs", std::move(programs)},
          {"options", options_of(request)},
          {"solvers", std::move(solvers)},
          {"meshes", std::move(meshes)}};
}

void save_request(const SavedRequest& saved, const fs::path& folder) {
  write_json(folder / kFile, {{"schema_version", kVersion},
                              {"command", saved.request.command},
                              {"started", saved.started},
                              {"changes", saved.changes},
                              {"identity", saved.identity}});
}

SavedRequest saved_request(const fs::path& folder) {
  const fs::path file = folder / kFile;
  if (!fs::exists(file)) {
    throw HarnessError("'" + folder.string() + "' holds no run to go on with (it has no " + kFile +
                       "): give the folder of one, or start one without --resume");
  }
  const Json json = read_json(file);
  try {
    if (json.at("schema_version") != kVersion) throw HarnessError("another version wrote it");
    SavedRequest saved;
    saved.identity = json.at("identity");
    json.at("started").get_to(saved.started);
    json.at("changes").get_to(saved.changes);
    const Json& options = saved.identity.at("options");
    RunRequest& request = saved.request;
    request.suite = parse_suite(options.at("suite"), "the suite");
    request.manifest = options.at("manifest").get<std::string>();
    options.at("benchmark_flags").get_to(request.benchmark_flags);
    request.pictured = pictured_named(options.at("recordings"));
    options.at("interleave").get_to(request.interleave);
    for (const auto& [name, path] : options.at("programs").items()) {
      request.programs.push_back({name, path.get<std::string>()});
    }
    options.at("cells").get_to(request.cells);
    json.at("command").get_to(request.command);
    request.resume = folder;
    return saved;
  } catch (const std::exception& error) {
    throw HarnessError("cannot go on with the run: " + file.string() + ": " + error.what());
  }
}

std::vector<std::string> differences(const Json& before, const Json& now) {
  const auto old_values = values_of(before), new_values = values_of(now);
  std::vector<std::string> all;
  for (const auto& [path, value] : new_values) {
    const auto old_value = old_values.find(path);
    if (old_value == old_values.end()) {
      all.push_back(path + " is " + value.dump() + " and was not there");
    } else if (old_value->second != value) {
      all.push_back(path + " is " + value.dump() + " and was " + old_value->second.dump());
    }
  }
  for (const auto& [path, value] : old_values) {
    if (!new_values.contains(path)) all.push_back(path + " was " + value.dump() + " and is gone");
  }
  return all;
}

}  // namespace geodesic::harness
