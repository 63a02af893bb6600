#include "harness/commands/solving/answers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

#include "harness/base/clock.h"
#include "harness/base/error.h"
#include "harness/external/external_solver.h"
#include "harness/measure/recorded_solve.h"
#include "harness/measure/solve_each.h"
#include "harness/results/counters.h"
#include "harness/results/row.h"
#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"
#include "meshes/isolines.h"
#include "meshes/path_file.h"
#include "meshes/row_solver.h"
#include "solvers/core/prepared_file.h"
#include "solvers/paths/paths.h"
#include "solvers/paths/straightest.h"

namespace geodesic::harness {
namespace {

struct Solved {
  std::vector<double> distances, at_targets;
  std::optional<Paths> paths = {};  // only of a solver that remembers them
  std::vector<Path> traced = {};    // by a solver itself, to the reached targets
  Json json = Json::object();
};

// Adds counters, phases and the peak of memory, which needs further solves.
void add_counters(const Problem& problem, Solved& solved) {
  const std::string& solver = problem.solver.name;
  const InsertedPoints* const inserted = problem.inserted.get();
  const Mesh& mesh = inserted == nullptr ? problem.mesh : inserted->mesh();
  const Query query = inserted == nullptr ? problem.query : inserted->translated(problem.query);
  std::vector<double> recorded(mesh.vertex_count());
  const RecordedSolve counted = record_solve(solver, mesh, query, recorded);
  for_each_counter(counted.counters,
                   [&](const char* name, const auto& value) { solved.json[name] = value; });
  if (counted.phases) solved.json["phase_seconds"] = *counted.phases;
  solved.json["solver_peak_bytes"] = counted.peak_bytes;
  if (problem.solver.deterministic && inserted == nullptr &&
      !identical(recorded, solved.distances)) {
    throw WrongAnswer(solver + ": a recorded solve gave other distances than the timed one");
  }
}

// A solver that is prepared for the mesh, or read as --prepared says, and what is known of that.
struct Prepared {
  std::unique_ptr<PointSolver> solver;
  Json json = Json::object();
};

PointSolver read_solver(const Problem& problem) {
  const std::string& file = problem.flags.prepared;
  if (problem.inserted != nullptr) {
    throw HarnessError("--prepared " + file + ": " + problem.solver.name +
                       " prepares again for points that are not vertices");
  }
  std::ifstream stream(file, std::ios::binary);
  try {
    return PointSolver(read_prepared(problem.mesh, stream));
  } catch (const std::invalid_argument& error) {
    throw HarnessError("--prepared " + file + ": " + error.what());
  }
}

Prepared prepare(const Problem& problem) {
  const SolveFlags& flags = problem.flags;
  std::optional<AtomicFile> file;
  if (!flags.save_prepared.empty()) file.emplace(flags.save_prepared);
  Prepared prepared;
  const Stopwatch watch;
  prepared.solver =
      flags.prepared.empty()
          ? std::make_unique<PointSolver>(problem.solver.name, problem.mesh, problem.inserted)
          : std::make_unique<PointSolver>(read_solver(problem));
  prepared.json["prepare_time_s"] =
      problem.solver.thread_count() > 1 ? watch.real_seconds() : watch.cpu_seconds();
  const Solver& solver = prepared.solver->solver();
  if (const auto certificate = solver.certificate()) prepared.json["certificate"] = *certificate;
  if (file) {
    save_prepared(solver, file->stream());
    file->commit();
  }
  return prepared;
}

Solved solve(const Problem& problem) {
  Solved solved{.distances = std::vector<double>(problem.mesh.vertex_count()),
                .at_targets = std::vector<double>(problem.query.targets.size())};
  restart_peak_resident_bytes();
  auto [prepared, preparation] = prepare(problem);

  const Stopwatch watch;
  const bool remembers = wants_paths(problem.flags) && problem.solver.abilities.paths;
  if (remembers) {
    solved.paths.emplace(solve_paths(prepared->solver(), problem.mesh, problem.query));
    solved.distances = solved.paths->distances();
    for (std::size_t i = 0; i < solved.at_targets.size(); ++i) {
      solved.at_targets[i] = solved.paths->distance_to_target(i);
    }
  } else {
    prepared->solve(problem.query, solved.distances, solved.at_targets);
  }
  solved.json["cpu_time_s"] = watch.cpu_seconds();
  solved.json["real_time_s"] = watch.real_seconds();
  solved.json.update(preparation);
  if (wants_paths(problem.flags) && !remembers) {
    for (const SurfacePoint& target : problem.query.targets) {
      if (solved.distances[target.vertex] == kInfinity) continue;
      solved.traced.push_back(
          prepared->solver().trace(problem.query, solved.distances, target.vertex));
    }
  }
  solved.json["instruction_set"] = name_of(prepared->solver().instruction_set());
  solved.json["process_peak_bytes"] = peak_resident_bytes();
  if (const auto* external = dynamic_cast<const ExternalSolver*>(&prepared->solver())) {
    const ExternalSolver::Times& times = external->last();
    solved.json.update({{"cpu_time_s", times.cpu},
                        {"real_time_s", times.real},
                        {"prepare_time_s", times.prepare},
                        {"process_peak_bytes", times.peak_bytes},
                        {"timed", times.of}});
    solved.json.erase("instruction_set");
  }
  solved.json["unreachable_vertices"] = unreachable_vertices(solved.distances);
  prepared.reset();
  if (problem.flags.counters) add_counters(problem, solved);
  return solved;
}

// Whether the query ends early, so that its distances cannot be compared with complete ones.
bool ends_early(const Query& query) { return std::isfinite(query.limit) || query.stop_at_targets; }

std::optional<std::vector<double>> closed_form(const Problem& problem, const Query& query) {
  std::vector<Index> sources;
  for (const Source& source : query.sources) {
    if (!source.at.is_vertex() || source.distance > 0) return std::nullopt;
    sources.push_back(source.at.vertex);
  }
  try {
    return closed_form_distances(problem.entry, problem.soup, sources);
  } catch (const HarnessError& error) {
    warn(error.what());
    return std::nullopt;
  }
}

// Compares with the closed form. If there is none and the user wants a check, compares with brute
// force or another exact solver, on a mesh with all points as vertices, so that targets are checked
// too. The values are null without a reference. @throws WrongAnswer
Json compare_with_reference(const Problem& problem, const Query& query,
                            std::span<const double> distances, std::span<const double> at_targets) {
  Json json{{"reference", nullptr}, {"max_relative_error", nullptr}};
  if (ends_early(query)) return json;
  const auto compare = [&](const Mesh& mesh, const Query& asked, std::span<const double> got,
                           const NamedDistances& reference) {
    const Verdict verdict =
        verify_distances(mesh, asked, Promise::of(problem.solver), got, reference, std::nullopt);
    if (!verdict.error.empty()) throw WrongAnswer(problem.solver.name + ": " + verdict.error);
    json = {{"reference", reference.by}, {"max_relative_error", verdict.errors.max}};
  };
  if (const auto known = closed_form(problem, query)) {
    compare(problem.mesh, query, distances, {kClosedForm, *known});
  } else if (problem.flags.check) {
    const Mesh as_given(problem.soup, Numbering::as_given,  // the points have these numbers
                        problem.mesh.non_manifold_edges());
    std::vector<SurfacePoint> points = query.targets;
    for (const Source& source : query.sources) points.push_back(source.at);
    const InsertedPoints inserted(as_given, points);
    const Query asked = inserted.translated(query);
    const ReferenceDistances reference =
        LocalReference(problem.solver, inserted.mesh()).distances(asked);
    if (!reference.remark.empty()) warn(problem.entry.name + ": " + reference.remark);
    std::vector<double> got = reference.values;  // inserted sources have no distance to compare
    std::ranges::copy(distances, got.begin());
    for (std::size_t i = 0; i < at_targets.size(); ++i) {
      got[asked.targets[i].vertex] = at_targets[i];
    }
    compare(inserted.mesh(), asked, got, {reference.by, reference.values});
  }
  return json;
}

// Writes the paths to the reached targets and warns about the other targets.
void write_paths(const Problem& problem, const Solved& solved, AtomicFile& file) {
  std::vector<Path> traced = solved.traced;
  for (std::size_t i = 0; i < problem.query.targets.size(); ++i) {
    if (!std::isfinite(solved.at_targets[i])) {
      warn("no path leads to the target " + written(problem.mesh, problem.query.targets[i]));
    } else if (solved.paths) {
      traced.push_back(solved.paths->to_target(i));
    }
  }
  file.stream() << path_bytes(traced, problem.flags.paths);
}

// Writes the isolines and returns what each level has.
Json write_isolines(const Problem& problem, const Solved& solved, AtomicFile& file) {
  const auto [count, given] = problem.levels;
  Json levels = Json::array();
  std::vector<Isoline> all;
  for (const double level : count > 0 ? equal_levels(solved.distances, count) : given) {
    std::vector<Isoline> lines = isolines(problem.mesh, solved.distances, {level});
    double length = 0;
    for (const Isoline& line : lines) length += line.length();
    levels.push_back({{"level", level},
                      {"lines", lines.size()},
                      {"closed", std::ranges::count(lines, true, &Isoline::closed)},
                      {"length", length}});
    std::ranges::move(lines, std::back_inserter(all));
  }
  file.stream() << isoline_bytes(all, problem.flags.isolines);
  return levels;
}

Json shown_sources(const Problem& problem, std::span<const Source> sources) {
  Json shown_each = Json::array();
  for (const Source& source : sources) shown_each.push_back(shown(problem.mesh, source));
  return shown_each;
}

Json shown_targets(const Problem& problem, const Solved& solved) {
  Json targets = Json::array();
  for (std::size_t i = 0; i < problem.query.targets.size(); ++i) {
    targets.push_back({{"point", shown(problem.mesh, {.at = problem.query.targets[i]})},
                       {"distance", solved.at_targets[i]}});
  }
  return targets;
}

}  // namespace

void warn(const std::string& warning) {
  std::cerr << "geodesic-bench: " << harmless(warning) << '\n';
}

Json solve_jointly(const Problem& problem, Outputs& outputs) {
  Solved solved = solve(problem);
  solved.json.update(
      compare_with_reference(problem, problem.query, solved.distances, solved.at_targets));
  if (outputs.distances) {
    std::vector<Index> nearest;
    if (problem.flags.nearest_source) nearest = solved.paths->nearest_sources();
    std::vector<double> angles;
    if (problem.flags.angles) {
      for (const PolarCoordinates& at : log_map(*solved.paths)) {
        angles.push_back(at.angle);
      }
    }
    outputs.distances->write(problem.mesh, solved.distances, {nearest, angles});
  }
  if (outputs.paths) write_paths(problem, solved, *outputs.paths);
  Json json = Json::object();
  json["sources"] = shown_sources(problem, problem.query.sources);
  if (!problem.query.targets.empty()) json["targets"] = shown_targets(problem, solved);
  json.update(solved.json);
  if (outputs.isolines) json["isolines"] = write_isolines(problem, solved, *outputs.isolines);
  return json;
}

Json solve_separately(const Problem& problem, Outputs& outputs) {
  const bool of_sets = !problem.flags.each;
  const auto keep = [&](const SingleSolve& solve) -> Kept {
    const std::vector<Source>& sources = problem.rows[solve.number];
    Kept kept{.json = Json::object(), .text = {}};
    if (of_sets) {
      kept.json["sources"] = shown_sources(problem, sources);
    } else {
      kept.json["source"] = shown(problem.mesh, sources.front());
    }
    if (!solve.at_targets.empty()) kept.json["at_targets"] = solve.at_targets;
    kept.json.update({{"cpu_time_s", solve.cpu_seconds},
                      {"real_time_s", solve.real_seconds},
                      {"instruction_set", name_of(solve.instruction_set)},
                      {"unreachable_vertices", unreachable_vertices(solve.distances)}});
    Query alone = problem.query;
    alone.sources = sources;
    kept.json.update(compare_with_reference(problem, alone, solve.distances, solve.at_targets));
    if (outputs.distances) {
      std::vector<std::string> points;
      for (const Source& source : sources) points.push_back(written(problem.mesh, source.at));
      kept.text = outputs.distances->row(join(points, ","), solve.distances);
    }
    return kept;
  };
  Json solves = Json::array();
  const auto deliver = [&](Kept kept) {
    solves.push_back(std::move(kept.json));
    if (outputs.distances) outputs.distances->write_row(kept.text);
  };
  if (outputs.distances) {
    outputs.distances->begin_rows(problem.rows.size(), problem.mesh.vertex_count(),
                                  of_sets ? "sources" : "source");
  }
  Json json = Json::object();
  for (const SurfacePoint& target : problem.query.targets) {
    json["targets"].push_back(shown(problem.mesh, {.at = target}));
  }
  restart_peak_resident_bytes();
  auto [prepared, preparation] = prepare(problem);
  const Stopwatch watch;
  solve_each(std::move(*prepared), problem.mesh, problem.rows, problem.query, problem.threads, keep,
             deliver);
  json.update(preparation);
  json.update({{"threads", problem.threads},
               {"cpu_time_s", watch.cpu_seconds()},
               {"real_time_s", watch.real_seconds()},
               {"process_peak_bytes", peak_resident_bytes()},
               {"solves", solves}});
  return json;
}

Json solve_pairs(const Problem& problem, Outputs& outputs) {
  restart_peak_resident_bytes();
  auto [prepared, preparation] = prepare(problem);
  const Stopwatch watch;
  SolverForEachThread solvers(std::move(*prepared));
  const std::vector<double> distances =
      problem.grouped->distances(problem.mesh, problem.threads, [&] { return solvers.next(); });
  Json json{{"pair_count", distances.size()}, {"solve_count", problem.grouped->sources().size()}};
  json.update(preparation);
  json.update({{"threads", problem.threads},
               {"cpu_time_s", watch.cpu_seconds()},
               {"real_time_s", watch.real_seconds()},
               {"process_peak_bytes", peak_resident_bytes()},
               {"unreachable_pairs", std::ranges::count(distances, kInfinity)}});
  if (outputs.distances) {
    outputs.distances->write_pairs(distances);
    return json;
  }
  for (std::size_t i = 0; i < distances.size(); ++i) {
    json["pairs"].push_back({{"from", shown(problem.mesh, {.at = problem.pairs[i].from})},
                             {"to", shown(problem.mesh, {.at = problem.pairs[i].to})},
                             {"distance", distances[i]}});
  }
  return json;
}

}  // namespace geodesic::harness
