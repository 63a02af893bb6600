#include "harness/commands/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "harness/base/clock.h"
#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/points.h"
#include "harness/corpus/solvers.h"
#include "harness/measure/large_pages.h"
#include "harness/measure/recorded_solve.h"
#include "harness/measure/solve_each.h"
#include "harness/results/counters.h"
#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"
#include "meshes/formats/bytes.h"
#include "meshes/inserted_points.h"
#include "meshes/load.h"
#include "meshes/path_file.h"
#include "solvers/core/registry.h"
#include "solvers/paths/paths.h"

namespace geodesic::harness {
namespace {

struct SolveFlags {
  std::string mesh, solver;
  std::vector<std::string> sources, targets;
  std::string sources_file, targets_file, output, paths;
  bool repair = false, each = false, check = false, counters = false;
  bool stop_at_targets = false, nearest_source = false;
  unsigned threads = 1;
  double limit = kInfinity;
  std::string vectors = kAutoVectors;
  std::string manifest = default_manifest().string();
};

// In file order, with the fewest digits that bring every double back.
std::string separated(std::span<const double> distances, char separator) {
  std::string text;
  for (const double d : distances) {
    append_text(text, d);
    text += separator;
  }
  return text;
}

// The same with the number of each vertex's source, -1 where no path leads.
std::string with_sources(std::span<const double> distances, std::span<const Index> sources) {
  std::string text;
  for (std::size_t v = 0; v < distances.size(); ++v) {
    append_text(text, distances[v]);
    append_text(text += ' ', sources[v] == kNone ? -1 : static_cast<std::int64_t>(sources[v]));
    text += '\n';
  }
  return text;
}

void warn(const std::string& warning) {
  std::cerr << "geodesic-bench: " << harmless(warning) << '\n';
}

// The problem, read and checked.
struct Problem {
  const SolveFlags& flags;
  const Description& solver;
  const MeshEntry& entry;
  const TriangleSoup& soup;
  const Mesh& mesh;
  Query query;
  Json places = Json::array();  // of points that were given by places in space
  std::shared_ptr<const InsertedPoints> inserted = {};
};

struct Solved {
  std::vector<double> distances, at_targets;
  std::optional<Paths> paths = {};
  Json json = Json::object();
};

bool are_vertices(const Query& query) {
  return std::ranges::all_of(query.targets, &SurfacePoint::is_vertex) &&
         std::ranges::all_of(query.sources, &SurfacePoint::is_vertex, &Source::at);
}

// Counters, phases and the peak of memory, which further solves take.
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

bool wants_paths(const SolveFlags& flags) { return flags.nearest_source || !flags.paths.empty(); }

Solved solve(const Problem& problem) {
  Solved solved{.distances = std::vector<double>(problem.mesh.vertex_count()),
                .at_targets = std::vector<double>(problem.query.targets.size())};
  restart_peak_resident_bytes();
  const Stopwatch preparation;
  std::optional<PointSolver> prepared(std::in_place, problem.solver.name, problem.mesh,
                                      problem.inserted);
  const double prepare_time = preparation.cpu_seconds();

  const Stopwatch watch;
  if (wants_paths(problem.flags)) {
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
  solved.json["prepare_time_s"] = prepare_time;
  solved.json["instruction_set"] = name_of(prepared->solver().instruction_set());
  solved.json["process_peak_bytes"] = peak_resident_bytes();
  solved.json["unreachable_vertices"] = unreachable_vertices(solved.distances);
  prepared.reset();
  if (problem.flags.counters) add_counters(problem, solved);
  return solved;
}

// Whether distances can be compared with others that end nowhere.
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

// The closed form; where there is none and the user asks for a check, brute force or another exact
// solver: on a mesh that has all points as vertices, so that targets are compared too. Empty
// without a reference. @throws WrongAnswer
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
    const Mesh as_given(problem.soup);  // whose numbers the points have
    std::vector<SurfacePoint> points = query.targets;
    for (const Source& source : query.sources) points.push_back(source.at);
    const InsertedPoints inserted(as_given, points);
    const Query asked = inserted.translated(query);
    LocalReference local(problem.solver, inserted.mesh());
    const std::vector<double> reference = local.distances(asked);
    std::vector<double> got = reference;  // inserted sources have nothing to compare
    std::ranges::copy(distances, got.begin());
    for (std::size_t i = 0; i < at_targets.size(); ++i) {
      got[asked.targets[i].vertex] = at_targets[i];
    }
    compare(inserted.mesh(), asked, got, {local.name(), reference});
  }
  return json;
}

// The paths to the targets that paths lead to.
void write_paths(const Problem& problem, const Paths& paths, AtomicFile& file) {
  std::vector<Path> traced;
  for (std::size_t i = 0; i < problem.query.targets.size(); ++i) {
    if (std::isfinite(paths.distance_to_target(i))) {
      traced.push_back(paths.to_target(i));
    } else {
      warn("no path leads to the target " + written(problem.mesh, problem.query.targets[i]));
    }
  }
  file.stream() << path_bytes(traced, problem.flags.paths);
}

Json shown_targets(const Problem& problem, const Solved& solved) {
  Json targets = Json::array();
  for (std::size_t i = 0; i < problem.query.targets.size(); ++i) {
    targets.push_back({{"point", shown(problem.mesh, {.at = problem.query.targets[i]})},
                       {"distance", solved.at_targets[i]}});
  }
  return targets;
}

// Where results go. Opened before the work: a bad path costs no solve.
struct Outputs {
  std::ostream* distances = nullptr;  // null: nowhere
  std::optional<AtomicFile> distances_file, paths_file;
};

// From the nearest of the sources: distances one a line.
Json solve_jointly(const Problem& problem, Outputs& outputs) {
  Solved solved = solve(problem);
  solved.json.update(
      compare_with_reference(problem, problem.query, solved.distances, solved.at_targets));
  if (outputs.distances != nullptr) {
    *outputs.distances << (problem.flags.nearest_source
                               ? with_sources(solved.distances, solved.paths->nearest_sources())
                               : separated(solved.distances, '\n'));
  }
  if (outputs.paths_file) write_paths(problem, *solved.paths, *outputs.paths_file);
  Json json = Json::object();
  for (const Source& source : problem.query.sources) {
    json["sources"].push_back(shown(problem.mesh, source));
  }
  if (!problem.query.targets.empty()) json["targets"] = shown_targets(problem, solved);
  json.update(solved.json);
  return json;
}

// From each source by itself: its distances in a line.
Json solve_separately(const Problem& problem, Outputs& outputs) {
  const std::vector<Source>& sources = problem.query.sources;
  const auto keep = [&](const SingleSolve& solve) -> Kept {
    const Source& source = sources[solve.number];
    Kept kept{.json = {{"source", shown(problem.mesh, source)}}, .text = {}};
    if (!solve.at_targets.empty()) kept.json["at_targets"] = solve.at_targets;
    kept.json.update({{"cpu_time_s", solve.cpu_seconds},
                      {"real_time_s", solve.real_seconds},
                      {"instruction_set", name_of(solve.instruction_set)},
                      {"unreachable_vertices", unreachable_vertices(solve.distances)}});
    Query alone = problem.query;
    alone.sources = {source};
    kept.json.update(compare_with_reference(problem, alone, solve.distances, solve.at_targets));
    if (outputs.distances != nullptr) {
      kept.text = separated(solve.distances, ' ');
      if (!kept.text.empty()) kept.text.back() = '\n';
    }
    return kept;
  };
  Json solves = Json::array();
  const auto deliver = [&](Kept kept) {
    solves.push_back(std::move(kept.json));
    if (outputs.distances != nullptr) *outputs.distances << kept.text;
  };
  Json json = Json::object();
  for (const SurfacePoint& target : problem.query.targets) {
    json["targets"].push_back(shown(problem.mesh, {.at = target}));
  }
  restart_peak_resident_bytes();
  const Stopwatch watch;
  solve_each(problem.solver.name, problem.mesh, problem.inserted, sources, problem.query,
             problem.flags.threads, keep, deliver);
  json.update({{"threads", problem.flags.threads},
               {"cpu_time_s", watch.cpu_seconds()},
               {"real_time_s", watch.real_seconds()},
               {"process_peak_bytes", peak_resident_bytes()},
               {"solves", solves}});
  return json;
}

// @param flag that names a file for results
void check_output(const std::string& flag, const std::string& output,
                  const std::filesystem::path& mesh) {
  std::error_code other;
  if (!output.empty() && std::filesystem::equivalent(output, mesh, other)) {
    throw HarnessError(flag + " '" + output +
                       "' is the mesh itself: results go to a file of their own");
  }
}

// Those of a flag, and of the file that another flag names.
std::vector<WrittenPoint> points_of(const std::string& flag, const std::vector<std::string>& words,
                                    const std::string& file) {
  std::vector<WrittenPoint> points;
  const auto add = [&points](const std::vector<WrittenPoint>& more) {
    points.insert(points.end(), more.begin(), more.end());
  };
  for (const std::string& word : words) add(parse_points(word, "--" + flag));
  if (!file.empty()) add(read_points(file, "--" + flag + "s-file"));
  return points;
}

void check_combination(const SolveFlags& flags) {
  const auto refuse = [](const std::string& why) { throw HarnessError(why); };
  const bool targets = !flags.targets.empty() || !flags.targets_file.empty();
  if (flags.sources.empty() && flags.sources_file.empty()) {
    refuse("--source or --sources-file is required");
  }
  if (flags.threads > 1 && !flags.each) {
    refuse("--threads is for --each: it solves several sources at a time");
  }
  if (flags.each && flags.counters) refuse("--counters is for one solve: leave out --each");
  if (flags.each && wants_paths(flags)) {
    refuse("--paths and --nearest-source are for one solve: leave out --each");
  }
  if (flags.check && (std::isfinite(flags.limit) || flags.stop_at_targets)) {
    refuse("--check is for distances without --limit and --stop-at-targets");
  }
  if (flags.stop_at_targets && !targets) refuse("--stop-at-targets needs --target");
  if (!flags.paths.empty() && !targets) refuse("--paths needs --target, where the paths lead");
  if (flags.nearest_source && flags.output.empty()) {
    refuse("--nearest-source needs --output: it is a column of that file");
  }
}

// What is asked must be within the solver's abilities.
void check_abilities(const SolveFlags& flags, const Description& solver, const Query& query) {
  if (flags.threads > 1 && !solver.abilities.concurrent_objects) {
    throw HarnessError(solver.name +
                       " cannot solve in several threads at the same time: leave out --threads");
  }
  if (!wants_paths(flags)) return;
  const auto can = [&](const Abilities& abilities) {
    return abilities.paths && (abilities.surface_sources || are_vertices({query.sources}));
  };
  if (can(solver.abilities)) return;
  std::vector<std::string> others;
  for (const Description* other : registered_solvers()) {
    if (can(other->abilities) && !other->by_name_only) others.push_back(other->name);
  }
  throw HarnessError(solver.name + " does not remember how paths arrive, which --paths and " +
                     "--nearest-source need; there are: " + join(others));
}

Problem read_problem(const SolveFlags& flags, const Description& solver, const MeshEntry& entry,
                     const BuiltMesh& built, const std::vector<WrittenPoint>& sources,
                     const std::vector<WrittenPoint>& targets) {
  Problem problem{flags, solver, entry, built.loaded.soup, *built.mesh, {}};
  problem.query.limit = flags.limit;
  problem.query.stop_at_targets = flags.stop_at_targets;
  const auto placed = [&](const WrittenPoint& point) {
    const PlacedPoint found = place(point, problem.mesh);
    if (found.from_surface) {
      problem.places.push_back({{"place", point.numbers},
                                {"point", written(problem.mesh, found.at)},
                                {"distance_to_surface", *found.from_surface}});
    }
    return found;
  };
  for (const WrittenPoint& source : sources) {
    const PlacedPoint at = placed(source);
    problem.query.sources.push_back({.at = at.at, .distance = at.initial});
  }
  for (const WrittenPoint& target : targets) {
    if (target.initial) throw HarnessError(target.text + ": a target has no initial distance");
    problem.query.targets.push_back(placed(target).at);
  }
  return problem;
}

void run_solve(const SolveFlags& flags) {
  check_combination(flags);
  const std::vector<WrittenPoint> sources = points_of("source", flags.sources, flags.sources_file);
  const std::vector<WrittenPoint> targets = points_of("target", flags.targets, flags.targets_file);
  const Description& solver = solver_named(flags.solver);
  set_instruction_set(instruction_set_named(flags.vectors));
  const MeshEntry entry = find_mesh(flags.mesh, flags.manifest);
  Outputs outputs;
  const bool to_standard_output = flags.output == "-";
  if (!flags.output.empty() && !to_standard_output) {
    check_output("--output", flags.output, entry.file);
    outputs.distances = &outputs.distances_file.emplace(flags.output).stream();
  } else if (to_standard_output) {
    outputs.distances = &std::cout;
  }
  if (!flags.paths.empty()) {
    check_path_file(flags.paths);
    check_output("--paths", flags.paths, entry.file);
    if (flags.paths == flags.output) throw HarnessError("--paths and --output name one file");
    outputs.paths_file.emplace(flags.paths);
  }
  const LargePages large_pages;
  const BuiltMesh built = build_mesh(entry.file, {.repair = flags.repair});
  for (const std::string& warning : built.loaded.warnings) {
    warn(entry.file.string() + ": " + warning);
  }
  const std::string unable = unsupported(solver, *built.mesh);
  if (!unable.empty()) throw HarnessError(unable);
  Problem problem = read_problem(flags, solver, entry, built, sources, targets);
  check_abilities(flags, solver, problem.query);
  std::vector<SurfacePoint> starts;
  for (const Source& source : problem.query.sources) starts.push_back(source.at);
  problem.inserted = insert_for(solver, problem.mesh, starts, problem.query.targets);

  Json json{{"solver", solver.name},
            {"mesh", entry.name},
            {"vertices", problem.mesh.vertex_count()},
            {"faces", problem.mesh.face_count()},
            {"limit", std::isinf(flags.limit) ? Json(nullptr) : Json(flags.limit)}};
  if (!problem.places.empty()) json["places"] = problem.places;
  json.update((flags.each ? solve_separately : solve_jointly)(problem, outputs));
  if (outputs.distances_file) outputs.distances_file->commit();
  if (outputs.paths_file) outputs.paths_file->commit();
  (to_standard_output ? std::cerr : std::cout) << json.dump(2) << std::endl;
}

}  // namespace

void add_solve_command(CLI::App& app) {
  const auto flags = std::make_shared<SolveFlags>();
  CLI::App* command = app.add_subcommand("solve", "Compute distances; print times as JSON");
  command->add_option("mesh", flags->mesh, "mesh file, or name of the manifest")
      ->required()
      ->type_name("MESH");
  command->add_option("--solver", flags->solver, "solver (see geodesic-bench list)")
      ->required()
      ->type_name("NAME");
  command
      ->add_option("--source", flags->sources,
                   std::string("source, repeatable, separated by commas: ") + kPointForms +
                       "; +0.5 behind it is an initial distance; distances are to the nearest "
                       "source")
      ->allow_extra_args(false)
      ->type_name("POINT");
  command->add_option("--sources-file", flags->sources_file, "file of sources: a JSON list, or CSV")
      ->type_name("FILE");
  command
      ->add_option("--target", flags->targets,
                   "point whose distance is wanted, written as a source, repeatable")
      ->allow_extra_args(false)
      ->type_name("POINT");
  command->add_option("--targets-file", flags->targets_file, "file of targets, as of sources")
      ->type_name("FILE");
  command->add_flag("--stop-at-targets", flags->stop_at_targets,
                    "end when the targets are reached; vertices farther than all of them are "
                    "unreachable");
  command
      ->add_option("--paths", flags->paths,
                   "file for the shortest paths to the targets: .obj, .ply or .json")
      ->type_name("FILE");
  command->add_flag("--nearest-source", flags->nearest_source,
                    "a second column of --output: the number of the nearest source in the list of "
                    "sources, -1 where no path leads");
  command->add_flag("--each", flags->each, "solve from each source separately");
  command->add_option("--threads", flags->threads, "number of sources to solve at a time (--each)")
      ->check(from_to(1, 1024));
  command
      ->add_option("--output", flags->output,
                   "file for the distances, one per line; with --each, one line per source; - is "
                   "standard output, and the JSON object then goes to standard error")
      ->type_name("FILE");
  command->add_flag(
      "--check", flags->check,
      "compare with brute force on up to 400 faces, otherwise with another exact solver");
  command->add_flag("--counters", flags->counters,
                    "solve again for counters, phases and the peak of memory");
  command->add_flag("--repair", flags->repair, "repair defects of the mesh, and say which");
  command->add_option("--limit", flags->limit, "distance beyond which vertices are unreachable")
      ->check(zero_or_above());
  command
      ->add_option("--vectors", flags->vectors,
                   "instruction set of the solver: auto, plain or avx2")
      ->type_name("SET");
  command->add_option("--manifest", flags->manifest, "list of meshes and corpora")
      ->type_name("FILE");
  command->footer(
      "\nExamples:\n  geodesic-bench solve bunny.ply --solver edge-based --source 0 --output "
      "d.txt\n"
      "  geodesic-bench solve bunny.ply --solver edge-based --source edge:3-7:0.25 --target "
      "at:0,0.1,0 --paths p.obj\n"
      "  geodesic-bench solve bunny.ply --solver mmp --source 0,17,99 --each --threads 4");
  command->callback([flags] { run_solve(*flags); });
}

}  // namespace geodesic::harness
