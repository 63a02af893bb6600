#include "harness/cells/references.h"

#include <iostream>

#include "harness/cells/process.h"
#include "harness/cells/spec.h"
#include "harness/error.h"
#include "harness/meshes/load.h"
#include "harness/verify/choose.h"
#include "harness/verify/closed_form.h"
#include "harness/verify/distance_file.h"
#include "solvers/registry.h"

namespace geodesic::harness {
namespace {

// Empty when the distances were written; otherwise why not, which is also told: the mesh is then
// not the one that the manifest describes.
std::string write_closed_form(const Cell& cell, const std::filesystem::path& file) {
  try {
    const MeshEntry& entry = cell.mesh->entry;
    write_distances(file,
                    closed_form_distances(entry, load_mesh(entry.file).soup, cell.source).value());
    return {};
  } catch (const std::exception& error) {
    std::cerr << "geodesic-bench: " << error.what() << '\n';
    return error.what();
  }
}

}  // namespace

std::string References::solve(const Cell& cell, const std::string& solver,
                              const std::filesystem::path& file) const {
  const auto unable = cell.mesh->unsupported.find(solver);
  if (unable != cell.mesh->unsupported.end()) return unable->second;
  const ReferenceSpec spec{.solver = solver,
                           .mesh_file = cell.mesh->entry.file.string(),
                           .source = cell.source,
                           .output = file.string()};
  const Ended ended = run_this_program({"reference", Json(spec).dump()}, [&] { waiting_(solver); });
  return ended.succeeded() ? "" : solver + ": " + ended.describe();
}

const std::string& References::compute(const Cell& cell, const std::string& solver,
                                       const std::filesystem::path& file) {
  const auto [at, first] = tried_.try_emplace(file.filename().string());
  if (!first) return at->second;
  return at->second =
             solver == kClosedForm ? write_closed_form(cell, file) : solve(cell, solver, file);
}

std::vector<std::string> References::candidates(const Cell& cell) const {
  std::vector<std::string> names;
  for (const Description* solver : rank_references(*cell.solver, registered_solvers(), named_)) {
    names.push_back(solver->name);
  }
  if (has_closed_form(cell.mesh->entry)) {
    const bool named_is_first = !names.empty() && names.front() == named_;
    names.insert(names.begin() + (named_is_first ? 1 : 0), kClosedForm);
  }
  return names;
}

Reference References::find(const Cell& cell) {
  std::vector<std::string> failures;
  for (const std::string& solver : candidates(cell)) {
    const std::string name = cell.mesh->entry.name + "__src" + std::to_string(cell.source) + "__" +
                             solver + ".distances";
    const std::string& failure = compute(cell, solver, folder_ / name);
    if (failure.empty()) return {solver, folder_ / name};
    failures.push_back(failure);
  }
  throw HarnessError("cannot be verified: no other exact solver gave distances (" +
                     (failures.empty() ? "none is registered" : join(failures, "; ")) + ")");
}

}  // namespace geodesic::harness
