#include "harness/cells/references.h"

#include "harness/cells/process.h"
#include "harness/cells/spec.h"
#include "harness/error.h"
#include "harness/verify/choose.h"
#include "solvers/registry.h"

namespace geodesic::harness {

const std::string& References::compute(const Cell& cell, const std::string& solver,
                                       const std::filesystem::path& file) {
  const auto [at, first] = tried_.try_emplace(file.filename().string());
  if (!first) return at->second;
  const auto unable = cell.mesh->unsupported.find(solver);
  if (unable != cell.mesh->unsupported.end()) return at->second = unable->second;
  const ReferenceSpec spec{.solver = solver,
                           .mesh_file = cell.mesh->entry.file.string(),
                           .repair = cell.mesh->entry.repair,
                           .source = cell.source,
                           .output = file.string()};
  const Ended ended = run_this_program({"reference", Json(spec).dump()});
  if (!ended.succeeded()) at->second = solver + ": " + ended.describe();
  return at->second;
}

Reference References::find(const Cell& cell) {
  std::vector<std::string> failures;
  for (const Description* solver : rank_references(*cell.solver, registered_solvers(), named_)) {
    const std::string name = cell.mesh->entry.name + "__src" + std::to_string(cell.source) + "__" +
                             solver->name + ".distances";
    const std::string& failure = compute(cell, solver->name, folder_ / name);
    if (failure.empty()) return {solver->name, folder_ / name};
    failures.push_back(failure);
  }
  throw HarnessError("cannot be verified: no other exact solver gave distances (" +
                     (failures.empty() ? "none is registered" : join(failures, "; ")) + ")");
}

}  // namespace geodesic::harness
