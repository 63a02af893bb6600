#include "harness/cells/plan.h"

#include <algorithm>
#include <set>

#include "harness/base/error.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/results/context.h"
#include "harness/results/row.h"
#include "meshes/load.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

std::vector<const Description*> chosen_solvers(const Suite& suite) {
  if (suite.reference && solver_named(*suite.reference).exactness != Exactness::exact) {
    throw HarnessError("'" + *suite.reference + "' is not exact: others cannot be verified by it");
  }
  std::vector<const Description*> solvers;
  if (suite.solvers.empty()) {
    solvers = registered_solvers();
    std::erase_if(solvers, [](const Description* solver) { return solver->by_name_only; });
  }
  for (const std::string& name : suite.solvers) solvers.push_back(&solver_named(name));
  return solvers;
}

std::vector<MeshEntry> chosen_meshes(const Suite& suite, const std::filesystem::path& manifest) {
  if (suite.meshes.empty()) return Manifest(manifest, dataset_cache()).corpus(suite.corpus);
  std::vector<MeshEntry> meshes;
  for (const std::string& name : suite.meshes) meshes.push_back(find_mesh(name, manifest));
  return meshes;
}

template <class Items, class Name>
void check_no_repetition(const std::string& kind, const Items& items, Name name) {
  std::set<std::string> seen;
  for (const auto& item : items) {
    if (!seen.insert(name(item)).second) {
      throw HarnessError("the suite has two " + kind + " named '" + name(item) + "'");
    }
  }
}

PlannedMesh plan_mesh(const MeshEntry& entry, const Suite& suite) {
  const TriangleSoup soup = load_mesh(entry.file).soup;
  const Mesh mesh(soup);
  PlannedMesh planned{.entry = entry,
                      .vertices = mesh.vertex_count(),
                      .facts = describe(entry, soup, mesh),
                      .sources = choose_sources(soup, entry.name, suite.sources, suite.seed)};
  for (const Description* solver : registered_solvers()) {
    const std::string why = unsupported(*solver, mesh);
    if (!why.empty()) planned.unsupported[solver->name] = why;
  }
  return planned;
}

}  // namespace

Plan make_plan(const Suite& suite, const std::filesystem::path& manifest,
               const std::vector<std::string>& only) {
  Plan plan{.solvers = chosen_solvers(suite), .only = only};
  std::vector<MeshEntry> entries = chosen_meshes(suite, manifest);
  check_no_repetition("solvers", plan.solvers, [](const auto* solver) { return solver->name; });
  check_no_repetition("meshes", entries, [](const auto& entry) { return entry.name; });
  if (!only.empty()) {
    std::erase_if(plan.solvers, [&](const Description* solver) {
      return std::ranges::none_of(
          only, [&](const std::string& cell) { return cell.starts_with(solver->name + '/'); });
    });
    std::erase_if(entries, [&](const MeshEntry& entry) {
      return std::ranges::none_of(only, [&](const std::string& cell) {
        return cell.find('/' + entry.name + "/src:") != std::string::npos;
      });
    });
  }
  std::vector<MeshEntry> absent;
  for (const MeshEntry& entry : entries) {
    if (!entry.available()) {
      absent.push_back(entry);
      plan.skipped.push_back({entry.name, how_to_get(entry)});
      continue;
    }
    try {
      plan.meshes.push_back(plan_mesh(entry, suite));
    } catch (const std::exception& error) {
      plan.skipped.push_back({entry.name, error.what(), true});
    }
  }
  if (plan.meshes.empty()) {
    std::string why = "nothing to run: ";
    why += entries.empty() ? "the corpus '" + suite.corpus + "' is empty"
                           : "no mesh of the suite can be read";
    if (!absent.empty()) why += "; " + how_to_get(absent);
    for (const SkippedMesh& skipped : plan.skipped) {
      if (skipped.unreadable) why += "; " + skipped.why;
    }
    throw HarnessError(why);
  }
  std::set<std::string> known;
  for (const Cell& cell : plan.cells()) known.insert(cell.name());
  for (const std::string& name : only) {
    if (!known.contains(name)) throw HarnessError("the run has no cell '" + name + "'");
  }
  return plan;
}

std::string Cell::name() const { return row_name(solver->name, mesh->entry.name, source); }

std::vector<Cell> Plan::chosen(std::vector<Cell> cells) const {
  if (!only.empty()) {
    const std::set<std::string> names(only.begin(), only.end());
    std::erase_if(cells, [&](const Cell& cell) { return !names.contains(cell.name()); });
  }
  return cells;
}

std::vector<Cell> Plan::cells() const {
  std::vector<Cell> all;
  for (const PlannedMesh& mesh : meshes) {
    for (const Index source : mesh.sources) {
      for (const Description* solver : solvers) {
        all.push_back({.mesh = &mesh, .source = source, .solver = solver});
      }
    }
  }
  return chosen(std::move(all));
}

std::vector<Cell> Plan::interleaved_cells(int repetitions) const {
  std::vector<const MeasuredProgram*> measured;
  for (const MeasuredProgram& program : programs) measured.push_back(&program);
  if (measured.empty()) measured.push_back(nullptr);
  std::vector<Cell> all;
  for (const PlannedMesh& mesh : meshes) {
    for (const Index source : mesh.sources) {
      for (int repetition = 0; repetition < repetitions; ++repetition) {
        const auto first = static_cast<std::ptrdiff_t>(all.size());
        for (const Description* solver : solvers) {
          for (const MeasuredProgram* program : measured) {
            all.push_back({&mesh, source, solver, program, repetition, repetitions});
          }
        }
        if (repetition % 2 == 1) std::reverse(all.begin() + first, all.end());
      }
    }
  }
  return chosen(std::move(all));
}

}  // namespace geodesic::harness
