#include "harness/run/plan.h"

#include <algorithm>
#include <map>
#include <set>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/corpus/solvers.h"
#include "harness/results/context.h"
#include "harness/results/row.h"
#include "harness/verify/references.h"
#include "meshes/load.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

std::vector<const Description*> chosen_solvers(const Suite& suite) {
  if (suite.reference && *suite.reference != kBruteForce &&
      solver_named(*suite.reference).exactness != Exactness::exact) {
    throw HarnessError("'" + *suite.reference + "' is not exact: others cannot be verified by it");
  }
  std::vector<const Description*> solvers;
  if (suite.solvers.empty()) {
    solvers = registered_solvers();
    std::erase_if(solvers, [](const Description* solver) { return solver->by_name_only; });
  }
  const auto named = solvers_named(suite.solvers);
  solvers.insert(solvers.end(), named.begin(), named.end());
  return solvers;
}

std::vector<MeshEntry> chosen_meshes(const RunRequest& request) {
  const Suite& suite = request.suite;
  if (suite.meshes.empty()) {
    return Manifest(request.manifest, dataset_cache()).corpus(suite.corpus);
  }
  std::vector<MeshEntry> meshes;
  for (const std::string& name : suite.meshes) meshes.push_back(find_mesh(name, request.manifest));
  if (request.folder) {
    const std::vector<std::string> names = names_below(*request.folder, suite.meshes);
    for (std::size_t i = 0; i < meshes.size(); ++i) meshes[i].name = names[i];
  }
  return meshes;
}

void check_no_repetition(const std::vector<const Description*>& solvers) {
  std::set<std::string> seen;
  for (const Description* solver : solvers) {
    if (!seen.insert(solver->name).second) {
      throw HarnessError("solver '" + solver->name + "' is named twice");
    }
  }
}

void check_no_repetition(const std::vector<MeshEntry>& meshes) {
  std::map<std::string, std::filesystem::path> seen;
  for (const MeshEntry& mesh : meshes) {
    const auto [at, added] = seen.emplace(mesh.name, mesh.file);
    if (added) continue;
    throw HarnessError("two meshes are named '" + mesh.name + "', and results go by name: rename " +
                       at->second.string() + " or " + mesh.file.string());
  }
}

// Removes the solvers and meshes that have none of the cells.
void restrict_to(const std::vector<std::string>& cells, std::vector<const Description*>& solvers,
                 std::vector<MeshEntry>& meshes) {
  const auto none = [&](const auto& holds) { return std::ranges::none_of(cells, holds); };
  std::erase_if(solvers, [&](const Description* solver) {
    return none([&](const std::string& cell) { return cell.starts_with(solver->name + '/'); });
  });
  std::erase_if(meshes, [&](const MeshEntry& mesh) {
    return none([&](const std::string& cell) {
      return cell.find('/' + mesh.name + "/src:") != std::string::npos;
    });
  });
}

// Single vertices, named by the manifest or else chosen by the seed, and then source sets.
std::vector<SourceSet> sources_of(const MeshEntry& entry, const TriangleSoup& soup,
                                  const Suite& suite) {
  std::vector<Index> vertices = entry.sources;
  if (vertices.empty()) {
    vertices = choose_sources(soup, entry.name, suite.sources, suite.seed);
  } else if (std::cmp_less(suite.sources, vertices.size())) {
    vertices.resize(static_cast<std::size_t>(suite.sources));
  }
  std::vector<SourceSet> sources;
  for (const Index v : vertices) sources.push_back(single_source(v));
  for (const std::string& set : suite.source_sets) {
    if (auto found = find_source_set(set, soup, entry.name, suite.seed)) {
      sources.push_back(std::move(*found));
    }
  }
  if (sources.empty()) {
    throw HarnessError("no vertex is a source (" + join(suite.source_sets, ", ") + ")");
  }
  return sources;
}

PlannedMesh plan_mesh(const MeshEntry& entry, const RunRequest& request) {
  const LoadedMesh loaded = load_mesh(entry.file, {.repair = request.repair});
  const Mesh mesh(loaded.soup);
  const Suite& suite = request.suite;
  PlannedMesh planned{.entry = entry,
                      .vertices = mesh.vertex_count(),
                      .facts = describe(entry, loaded.soup, mesh),
                      .run_sources = sources_of(entry, loaded.soup, suite)};
  check_sum(entry, planned.facts.at("sha256"));
  planned.sources = planned.run_sources;
  if (suite.further_sources > 0) {
    planned.further_sources =
        choose_sources(loaded.soup, entry.name, suite.further_sources, suite.seed);
  }
  if (!loaded.repairs.empty()) planned.facts["repaired"] = true;
  for (const Description* solver : registered_solvers()) {
    const std::string why = unsupported(*solver, mesh);
    if (!why.empty()) planned.unsupported[solver->name] = why;
  }
  return planned;
}

void add_mesh(const MeshEntry& entry, const RunRequest& request, Plan& plan) {
  if (!entry.available()) {
    plan.skipped.push_back({entry.name, how_to_get(entry)});
    return;
  }
  try {
    plan.meshes.push_back(plan_mesh(entry, request));
  } catch (const std::exception& error) {
    plan.skipped.push_back({entry.name, error.what(), !request.folder});
  }
}

// A mesh has no more vertices than its file has bytes.
std::vector<ShardedMesh> sharded(const std::vector<MeshEntry>& entries, const Suite& suite) {
  std::vector<ShardedMesh> meshes;
  for (const MeshEntry& entry : entries) {
    std::error_code absent;
    const std::uintmax_t size = std::filesystem::file_size(entry.file, absent);
    const std::uintmax_t bytes = absent ? 0 : size;
    auto sources = std::min(static_cast<std::uintmax_t>(suite.sources), bytes);
    if (!entry.sources.empty()) sources = std::min(sources, entry.sources.size());
    sources += suite.source_sets.size();
    meshes.push_back({entry.name, bytes, std::max(static_cast<int>(sources), 1)});
  }
  return meshes;
}

// Keeps only the sources at these places in the last mesh, if that is the named one. Small meshes
// have fewer sources than requested; a mesh without any of the places is removed.
void keep_sources(const std::vector<int>& places, const std::string& name, Plan& plan) {
  if (plan.meshes.empty() || plan.meshes.back().entry.name != name) return;
  PlannedMesh& mesh = plan.meshes.back();
  mesh.sources.clear();
  for (const int place : places) {
    if (std::cmp_less(place, mesh.run_sources.size())) {
      mesh.sources.push_back(mesh.run_sources[static_cast<std::size_t>(place)]);
    }
  }
  if (mesh.sources.empty()) plan.meshes.pop_back();
}

[[noreturn]] void refuse_empty(const Plan& plan, const std::vector<MeshEntry>& entries,
                               const std::string& corpus) {
  std::string why = "nothing to run: ";
  why +=
      entries.empty() ? "the corpus '" + corpus + "' is empty" : "no mesh of the suite can be read";
  std::vector<MeshEntry> absent;
  for (const MeshEntry& entry : entries) {
    if (!entry.available()) absent.push_back(entry);
  }
  if (!absent.empty()) why += "; " + how_to_get(absent);
  for (const SkippedMesh& skipped : plan.skipped) {
    if (skipped.unreadable) why += "; " + skipped.why;
  }
  if (absent.empty() && why.find(';') == std::string::npos && !plan.skipped.empty()) {
    why += "; the first of " + std::to_string(plan.skipped.size()) + ": " + plan.skipped[0].why;
  }
  throw HarnessError(why);
}

}  // namespace

Json names_in_json(const std::vector<SourceSet>& sources) {
  Json names = Json::array();
  for (const SourceSet& source : sources) names.push_back(source_in_json(source.name));
  return names;
}

Json describe(const PlannedMesh& mesh, const SourceSet& source) {
  return {{"vertices", source.vertices.size()}, {"file", source_file(mesh, source).string()}};
}

std::filesystem::path source_file(const PlannedMesh& mesh, const SourceSet& source) {
  return std::filesystem::path("sources") /
         (as_file_name(mesh.entry.name + "__" + source.name) + ".json");
}

bool has_further_sources(const Cell& cell) {
  return !cell.mesh->further_sources.empty() && cell.is_first_repetition() &&
         cell.is_of_first_source();
}

std::filesystem::path further_sources_file(const PlannedMesh& mesh) {
  return std::filesystem::path("sources") / (as_file_name(mesh.entry.name) + ".further.json");
}

Json outline(const RunRequest& request) {
  const std::vector<const Description*> solvers = chosen_solvers(request.suite);
  const std::vector<MeshEntry> entries = chosen_meshes(request);
  check_no_repetition(solvers);
  check_no_repetition(entries);
  const std::vector<ShardedMesh> meshes = sharded(entries, request.suite);
  int pairs = 0;
  for (const ShardedMesh& mesh : meshes) pairs += mesh.sources;
  const std::size_t cells_of_pair =
      solvers.size() * std::max<std::size_t>(request.programs.size(), 1);
  Json json{{"meshes", meshes.size()},
            {"pairs", pairs},
            {"solvers", solvers.size()},
            {"cells", cells_of_pair * static_cast<std::size_t>(pairs)}};
  if (request.shard) {
    std::size_t ours = 0, of_meshes = 0;
    for (const std::vector<int>& places : sources_of_shard(meshes, *request.shard)) {
      ours += places.size();
      of_meshes += places.empty() ? 0u : 1u;
    }
    json["shard"] = {{"index", request.shard->index},
                     {"of", request.shard->of},
                     {"meshes", of_meshes},
                     {"pairs", ours},
                     {"cells", cells_of_pair * ours}};
  }
  return json;
}

Plan make_plan(const RunRequest& request) {
  Plan plan{.solvers = chosen_solvers(request.suite)};
  for (const std::string& cell : request.cells) plan.only.push_back(canonical_cell(cell));
  std::vector<MeshEntry> entries = chosen_meshes(request);
  check_no_repetition(plan.solvers);
  check_no_repetition(entries);
  if (!plan.only.empty()) restrict_to(plan.only, plan.solvers, entries);
  if (!request.shard) {
    for (const MeshEntry& entry : entries) add_mesh(entry, request, plan);
  } else {
    plan.whole_run = sharded(entries, request.suite);
    const auto places = sources_of_shard(plan.whole_run, *request.shard);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (places[i].empty()) continue;
      add_mesh(entries[i], request, plan);
      keep_sources(places[i], entries[i].name, plan);
    }
  }
  if (plan.meshes.empty() && plan.only.empty() && !request.shard) {
    refuse_empty(plan, entries, request.suite.corpus);
  }
  std::set<std::string> known;
  for (const Cell& cell : plan.cells()) known.insert(cell.name());
  for (const std::string& name : plan.only) {
    if (!known.contains(name)) throw HarnessError("the run has no cell '" + name + "'");
  }
  return plan;
}

std::string Cell::name() const { return row_name(solver->name, mesh->entry.name, source->name); }

const std::string* PlannedMesh::unsupported_by(std::string_view solver,
                                               const SourceSet& source) const {
  static const std::string several = "supports a single source only";
  if (source.vertices.size() > 1 && !find_solver(solver)->abilities.multiple_sources) {
    return &several;
  }
  const auto why = unsupported.find(base_name(solver));
  return why == unsupported.end() ? nullptr : &why->second;
}

const std::string* Cell::unsupported() const { return mesh->unsupported_by(solver->name, *source); }

bool leaves_recordings(const Cell& cell, Recordings choice) {
  if (!cell.is_first_repetition()) return false;
  if (choice != Recordings::automatic) return choice == Recordings::all;
  const PlannedMesh& mesh = *cell.mesh;
  return cell.is_of_first_source() && mesh.vertices >= kLeastRecorded &&
         mesh.vertices <= kMostRecorded;
}

std::vector<Cell> Plan::interleaved_cells(int repetitions) const {
  std::vector<const Program*> measured;
  for (const Program& program : programs) measured.push_back(&program);
  if (measured.empty()) measured.push_back(nullptr);
  std::vector<Cell> all;
  const auto add_repetition = [&](const PlannedMesh& mesh, const SourceSet& source,
                                  int repetition) {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    for (const Description* solver : solvers) {
      for (const Program* program : measured) {
        all.push_back({&mesh, &source, solver, program, repetition, std::max(repetitions, 1)});
      }
    }
    if (repetition % 2 == 1) std::reverse(all.begin() + first, all.end());
  };
  for (const PlannedMesh& mesh : meshes) {
    for (const SourceSet& source : mesh.sources) {
      if (repetitions < 0) add_repetition(mesh, source, -1);
      for (int r = 0; r < repetitions; ++r) add_repetition(mesh, source, r);
    }
  }
  if (!only.empty()) {
    const std::set<std::string> names(only.begin(), only.end());
    std::erase_if(all, [&](const Cell& cell) { return !names.contains(cell.name()); });
  }
  return all;
}

Json run_context(const RunRequest& request, const Plan& plan, const PlannedMesh* mesh,
                 const Description* solver) {
  const Suite& suite = request.suite;
  Json json = program_context();
  json["started"] = utc_now();
  json["environments"] = request.environments;
  json["corpus"] = suite.corpus;
  json["seed"] = suite.seed;
  json["repetitions"] = suite.repetitions;
  json["time_limit"] = suite.time_limit;
  if (suite.memory_limit) json["memory_limit"] = *suite.memory_limit;
  json["expected"] = suite.expected;
  json["command"] = request.command;
  json["meshes"] = Json::array();
  json["sources"] = Json::object();
  for (const PlannedMesh& each : plan.meshes) {
    if (mesh != nullptr && mesh != &each) continue;
    json["meshes"].push_back(each.facts);
    json["sources"][each.entry.name] = names_in_json(each.sources);
    for (const SourceSet& source : each.sources) {
      if (source.is_single()) continue;
      json["source_sets"][each.entry.name][source.name] = describe(each, source);
    }
  }
  json["solvers"] = Json::array();
  for (const Description* each : plan.solvers) {
    if (solver == nullptr || solver == each) json["solvers"].push_back(describe(*each));
  }
  json["skipped"] = Json::array();
  if (mesh == nullptr) {
    for (const SkippedMesh& skipped : plan.skipped) {
      Json one{{"mesh", skipped.name}, {"solver", nullptr}, {"why", skipped.why}};
      if (skipped.unreadable) one["unreadable"] = true;
      json["skipped"].push_back(std::move(one));
    }
  }
  if (request.interleave) json["interleaved"] = true;
  return json;
}

}  // namespace geodesic::harness
