#include "harness/run/reference_files.h"

#include <iostream>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/process.h"
#include "harness/run/cell.h"
#include "harness/run/isolated.h"
#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"
#include "meshes/load.h"
#include "meshes/threads.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

// Writes distances by kClosedForm or kBruteForce. Returns why they could not be written; empty when
// they were. The reason is also printed: the mesh is not the one that the manifest describes.
std::string write_known(const std::string& by, const Cell& cell, bool repair,
                        const std::filesystem::path& file) {
  try {
    const MeshEntry& entry = cell.mesh->entry;
    const TriangleSoup soup = load_mesh(entry.file, {.repair = repair}).soup;
    if (by == kBruteForce) {
      write_distances(file, BruteForce(Mesh(soup)).distances(cell.source->query().sources));
    } else {
      write_distances(file, closed_form_distances(entry, soup, cell.source->vertices).value());
    }
    return {};
  } catch (const std::exception& error) {
    std::cerr << "geodesic-bench: " << error.what() << '\n';
    return error.what();
  }
}

}  // namespace

Failure ReferenceFiles::solve(const Cell& cell, const std::string& solver,
                              const std::filesystem::path& file, bool each) {
  if (const std::string* why = cell.mesh->unsupported_by(solver, *cell.source)) {
    return {Outcome::unsupported, *why};
  }
  ReferenceSpec spec{.solver = solver,
                     .mesh_file = cell.mesh->entry.file.string(),
                     .source = cell.source->vertices.front(),
                     .each = each,
                     .output = file.string(),
                     .repair = request_.repair};
  const std::filesystem::path run = folder_.parent_path();
  if (each) {
    spec.sources_file = run / further_sources_file(*cell.mesh);
  } else if (!cell.source->is_single()) {
    spec.sources_file = run / source_file(*cell.mesh, *cell.source);
  }
  ProcessLimits limits = limits_of(request_.suite);
  limits.memory_bytes /= at_a_time_;
  const auto waiting = [&] {
    const std::lock_guard lock(mutex_);
    waiting_(solver);
  };
  const Ended ended = run_geodesic_bench({"reference", Json(spec).dump()}, waiting, limits);
  if (ended.succeeded()) return {};
  Failure failure = failure_of(ended, limits);
  failure.why = solver + ": " + std::string(name_of(failure.outcome)) + ": " + failure.why;
  return failure;
}

std::string ReferenceFiles::compute(const Cell& cell, const std::string& solver,
                                    const std::filesystem::path& file, bool each) {
  std::unique_lock lock(mutex_);
  const auto [at, first] = tried_.try_emplace(file.filename().string());
  lock.unlock();
  if (!first) return at->second;
  if (solver == kClosedForm || solver == kBruteForce) {
    return at->second = write_known(solver, cell, request_.repair, file);
  }
  const Failure failure = solve(cell, solver, file, each);
  at->second = failure.why;
  if (failure.outcome == Outcome::out_of_memory && at_a_time_ > 1) {
    lock.lock();
    tried_.erase(at);  // alone it has more
  }
  return failure.why;
}

std::filesystem::path ReferenceFiles::file_of(const Cell& cell, const std::string& source,
                                              const std::string& by) const {
  const std::string name = cell.mesh->entry.name + "__src" + source + "__" + by;
  return folder_ / (as_file_name(name) + ".distances");
}

Reference ReferenceFiles::find_further(const Cell& cell) {
  const std::vector<std::string> candidates =
      reference_candidates(*cell.solver, {.named = request_.suite.reference, .many_sources = true});
  std::vector<std::string> failures;
  for (const std::string& by : candidates) {
    const std::filesystem::path file = file_of(cell, "each", by);
    const std::string failure = compute(cell, by, file, true);
    if (failure.empty()) return {by, file};
    failures.push_back(failure);
  }
  throw HarnessError("its further sources cannot be verified: " + join(failures, "; "));
}

Reference ReferenceFiles::find(const Cell& cell) {
  const PlannedMesh& mesh = *cell.mesh;
  const std::optional<std::string>& named = request_.suite.reference;
  const Json& faces = mesh.facts["faces"];
  const ReferenceSources sources{.named = named,
                                 .closed_form = has_closed_form(mesh.entry),
                                 .brute_force = named == kBruteForce && faces <= kBruteForceFaces,
                                 .deciding_brute_force = faces <= kDecidingFaces,
                                 .many_sources = cell.source->vertices.size() > kFewSources};
  const auto file = [&](const std::string& by) { return file_of(cell, cell.source->name, by); };
  const auto ask = [&](const std::string& by) {
    const std::string failure = compute(cell, by, file(by));
    if (!failure.empty()) throw NoReference(failure);
    return read_distances(file(by), mesh.vertices);
  };
  try {
    const auto [by, distances, remark] =
        choose_reference(reference_candidates(*cell.solver, sources), ask);
    const std::string line = mesh.entry.name + ", source " + cell.source->name + ": " + remark;
    const std::lock_guard lock(mutex_);
    if (!remark.empty() && reported_.insert(line).second) std::cerr << line << '\n';
    return {by, file(by)};
  } catch (const NoReference& why) {
    throw HarnessError("cannot be verified: " + std::string(why.what()));
  }
}

void ReferenceFiles::compute_ahead(std::span<const Cell* const> cells) {
  std::map<const SourceSet*, std::vector<const Cell*>> by_source;
  for (const Cell* cell : cells) {
    if (cell->unsupported() == nullptr) by_source[cell->source].push_back(cell);
  }
  std::vector<std::vector<const Cell*>> sources;
  for (auto& [source, of_source] : by_source) sources.push_back(std::move(of_source));
  if (sources.empty()) return;
  at_a_time_ = sources.size();
  do_in_threads(sources.size(), static_cast<unsigned>(sources.size()), [&]() -> Worker {
    return [&](std::size_t i) {
      for (const Cell* cell : sources[i]) {
        try {
          find(*cell);
        } catch (const HarnessError&) {
        }
      }
    };
  });
  at_a_time_ = 1;
}

}  // namespace geodesic::harness
