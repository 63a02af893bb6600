#include "harness/external/external_program.h"

#include <map>
#include <memory>
#include <sstream>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/base/plugins.h"
#include "harness/base/schema.h"
#include "harness/external/external_solver.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr const char* kDescription = "solver.json";

const Json& schema() {
  static const Json schema = Json::parse(R"({
    "type": "object",
    "required": ["name", "command"],
    "additionalProperties": false,
    "properties": {
      "name": {"type": "string", "pattern": "^[a-z0-9]+(-[a-z0-9]+)*$",
               "must_be": "lower-case letters and digits, joined by '-'"},
      "command": {"type": "string"},
      "promise": {"enum": ["exact", "upper_bound", "unbounded", "bounded"]},
      "error_bound": {"type": "number"},
      "paper": {"type": "string"},
      "remarks": {"type": "string"},
      "install": {"type": "string"}
    }
  })");
  return schema;
}

Exactness promise_named(const std::string& name) {
  if (name == "exact") return Exactness::exact;
  if (name == "upper_bound") return Exactness::upper_bound;
  return name == "bounded" ? Exactness::bounded : Exactness::unbounded;
}

ExternalProgram described(const Json& json, const fs::path& folder) {
  check_schema(json, schema());
  ExternalProgram program{.name = json.at("name"),
                          .command = json.at("command"),
                          .promise = promise_named(json.value("promise", "unbounded")),
                          .error_bound = json.value("error_bound", 0.0),
                          .paper = json.value("paper", ""),
                          .remarks = json.value("remarks", ""),
                          .install = json.value("install", ""),
                          .folder = folder};
  if ((program.promise == Exactness::bounded) != (program.error_bound > 0)) {
    throw HarnessError("error_bound belongs to the promise 'bounded'");
  }
  const auto has = [&](const char* place) {
    return program.command.find(place) != std::string::npos;
  };
  const bool has_mesh = has("{mesh") || (has("{vertices.npy}") && has("{faces.npy}"));
  if (!has_mesh || !has("{sources}") || !has("{distances")) {
    throw HarnessError("command: it needs {mesh}, {sources} and {distances}");
  }
  return program;
}

ExternalProgram read(const std::string& word) {
  if (const fs::path folder = word; fs::is_directory(folder)) {
    return described(read_json(folder / kDescription), fs::canonical(folder));
  }
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) {
    throw HarnessError(std::string("it is neither NAME=COMMAND nor a folder with a ") +
                       kDescription);
  }
  return described({{"name", word.substr(0, equals)}, {"command", word.substr(equals + 1)}}, {});
}

// Checksum of the command and of the program's files: another script is another solver.
std::string sum_of(const ExternalProgram& program) {
  std::string all = program.command;
  std::istringstream words(program.command);
  for (std::string word; words >> word;) {
    std::erase_if(word, [](char c) { return c == '\'' || c == '"'; });
    if (fs::is_regular_file(word)) all += sha256_of_file(word);
  }
  if (!program.folder.empty()) {
    std::map<std::string, std::string> sums;
    for (const auto& entry : fs::directory_iterator(program.folder)) {
      if (entry.is_regular_file()) sums[entry.path().filename()] = sha256_of_file(entry.path());
    }
    for (const auto& [name, sum] : sums) all += name + sum;
  }
  return sha256_of(all);
}

// Never freed, because solvers refer to them.
std::map<std::string, ExternalProgram, std::less<>>& programs() {
  static auto& all = *new std::map<std::string, ExternalProgram, std::less<>>;
  return all;
}

void add(const ExternalProgram& program) {
  const ExternalProgram& kept = programs().try_emplace(program.name, program).first->second;
  Description description{
      .name = program.name,
      .family = "external",
      .paper = program.paper,
      .exactness = program.promise,
      .error_bound = [](const Description& d) { return programs().at(d.name).error_bound; },
      .deterministic = false,
      .by_name_only = true,
      .abilities = {.initial_distances = false},
      .remarks =
          program.remarks.empty() ? "an external program: " + program.command : program.remarks};
  register_solver(std::move(description),
                  [&kept](const Mesh& mesh, const Description& d, PreparedReader* /*saved*/) {
                    return std::make_unique<ExternalSolver>(mesh, d, kept);
                  });
}

}  // namespace

void add_external_solver(const std::string& word) {
  try {
    const ExternalProgram program = read(word);
    add(program);
    const std::string given = program.folder.empty() ? word : program.folder.string();
    note_plugin({.option = kExternalOption,
                 .value = given,
                 .sha256 = sum_of(program),
                 .solvers = {program.name}});
  } catch (const std::exception& error) {
    throw HarnessError("external solver '" + excerpt(word) + "': " + error.what());
  }
}

void load_by_option(const std::string& option, const std::string& value) {
  if (option == kPluginOption) {
    load_plugin(value);
  } else {
    add_external_solver(value);
  }
}

}  // namespace geodesic::harness
