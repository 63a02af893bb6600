#include "harness/commands/commands.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "harness/base/clock.h"
#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/measure/recorded_solve.h"
#include "harness/measure/solve_each.h"
#include "harness/results/counters.h"
#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"
#include "meshes/load.h"
#include "meshes/mesh_file.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

struct SolveFlags {
  std::string mesh, solver;
  std::vector<Index> sources;
  std::string sources_file, output;
  bool repair = false, each = false, check = false, counters = false;
  unsigned threads = 1;
  double limit = kInfinity;
  std::string vectors = kAutoVectors;
  std::string manifest = default_manifest().string();
};

// In file order, 17 significant digits: every double survives.
std::string separated(std::span<const double> distances, char separator) {
  std::string text;
  char number[40];
  for (const double d : distances) {
    std::snprintf(number, sizeof number, "%.17g", d);
    text += std::isinf(d) ? "inf" : number;
    text += separator;
  }
  return text;
}

void warn(const std::string& warning) {
  std::cerr << "geodesic-bench: " << harmless(warning) << '\n';
}

TriangleSoup load(const SolveFlags& flags, const MeshEntry& entry) {
  LoadedMesh loaded = load_mesh(entry.file, {.repair = flags.repair});
  for (const std::string& warning : loaded.warnings) warn(entry.file.string() + ": " + warning);
  return std::move(loaded.soup);
}

Query query_from(std::span<const Index> sources, double limit = kInfinity) {
  Query query{.sources = {}, .limit = limit};
  for (const Index v : sources) query.sources.push_back({.at = v});
  return query;
}

// The problem, read and checked.
struct Problem {
  const SolveFlags& flags;
  const Description& solver;
  const MeshEntry& entry;
  const TriangleSoup& soup;
  const Mesh& mesh;
};

struct Solved {
  std::vector<double> distances;
  Json json;
};

// Counters, phases and the peak of memory, which further solves take.
void add_counters(const Description& solver, const Mesh& mesh, const Query& query, Solved& solved) {
  std::vector<double> recorded(mesh.vertex_count());
  const RecordedSolve counted = record_solve(solver.name, mesh, query, recorded);
  for_each_counter(counted.counters,
                   [&](const char* name, const auto& value) { solved.json[name] = value; });
  if (counted.phases) solved.json["phase_seconds"] = *counted.phases;
  solved.json["solver_peak_bytes"] = counted.peak_bytes;
  if (solver.deterministic && !identical(recorded, solved.distances)) {
    throw WrongAnswer(solver.name + ": a recorded solve gave other distances than the timed one");
  }
}

Solved solve(const SolveFlags& flags, const Description& solver, const Mesh& mesh) {
  const Query query = query_from(flags.sources, flags.limit);
  Solved solved{.distances = std::vector<double>(mesh.vertex_count()), .json = Json::object()};
  restart_peak_resident_bytes();
  const Stopwatch preparation;
  std::unique_ptr<Solver> prepared = make_solver(solver.name, mesh);
  const double prepare_time = preparation.cpu_seconds();

  const Stopwatch watch;
  prepared->solve(query, solved.distances);
  solved.json["cpu_time_s"] = watch.cpu_seconds();
  solved.json["real_time_s"] = watch.real_seconds();
  solved.json["prepare_time_s"] = prepare_time;
  solved.json["instruction_set"] = name_of(prepared->instruction_set());
  solved.json["process_peak_bytes"] = peak_resident_bytes();
  solved.json["unreachable_vertices"] = unreachable_vertices(solved.distances);
  prepared.reset();
  if (flags.counters) add_counters(solver, mesh, query, solved);
  return solved;
}

struct NamedReference {
  std::string name;
  std::vector<double> distances;
};

// The closed form; where there is none and the user asks for a check, brute force or another exact
// solver. Nothing otherwise.
std::optional<NamedReference> reference_for(const Problem& problem,
                                            std::span<const Index> sources) {
  if (std::isfinite(problem.flags.limit)) return std::nullopt;
  try {
    auto known = closed_form_distances(problem.entry, problem.soup, sources);
    if (known) return NamedReference{kClosedForm, *std::move(known)};
  } catch (const HarnessError& error) {
    warn(error.what());
  }
  if (!problem.flags.check) return std::nullopt;
  const Mesh as_given(problem.soup);  // whose numbers the sources are
  LocalReference local(problem.solver, as_given);
  return NamedReference{local.name(), local.distances(query_from(sources))};
}

// What the distances were compared with, and how far they are from it. @throws WrongAnswer
Json compare_with_reference(const Problem& problem, std::span<const Index> sources,
                            std::span<const double> distances) {
  const auto reference = reference_for(problem, sources);
  if (!reference) return {{"reference", nullptr}, {"max_relative_error", nullptr}};
  const Verdict verdict =
      verify_distances(problem.mesh, query_from(sources), Promise::of(problem.solver), distances,
                       {reference->name, reference->distances}, std::nullopt);
  if (!verdict.error.empty()) throw WrongAnswer(problem.solver.name + ": " + verdict.error);
  return {{"reference", reference->name}, {"max_relative_error", verdict.errors.max}};
}

// From the nearest of the sources: distances one a line.
Json solve_jointly(const Problem& problem, std::ostream* output) {
  Solved solved = solve(problem.flags, problem.solver, problem.mesh);
  solved.json.update(compare_with_reference(problem, problem.flags.sources, solved.distances));
  if (output != nullptr) *output << separated(solved.distances, '\n');
  Json json{{"sources", problem.flags.sources}};
  json.update(solved.json);
  return json;
}

// From each source by itself: its distances in a line.
Json solve_separately(const Problem& problem, std::ostream* output) {
  const auto keep = [&](const SingleSolve& solve) -> Kept {
    Kept kept{.json = {{"source", solve.source},
                       {"cpu_time_s", solve.cpu_seconds},
                       {"real_time_s", solve.real_seconds},
                       {"instruction_set", name_of(solve.instruction_set)},
                       {"unreachable_vertices", unreachable_vertices(solve.distances)}},
              .text = {}};
    kept.json.update(compare_with_reference(problem, std::span(&solve.source, 1), solve.distances));
    if (output != nullptr) {
      kept.text = separated(solve.distances, ' ');
      if (!kept.text.empty()) kept.text.back() = '\n';
    }
    return kept;
  };
  Json solves = Json::array();
  const auto deliver = [&](Kept kept) {
    solves.push_back(std::move(kept.json));
    if (output != nullptr) *output << kept.text;
  };
  restart_peak_resident_bytes();
  const Stopwatch watch;
  solve_each(problem.solver.name, problem.mesh, problem.flags.sources, problem.flags.limit,
             problem.flags.threads, keep, deliver);
  return {{"threads", problem.flags.threads},
          {"cpu_time_s", watch.cpu_seconds()},
          {"real_time_s", watch.real_seconds()},
          {"process_peak_bytes", peak_resident_bytes()},
          {"solves", solves}};
}

void check_output(const std::string& output, const std::filesystem::path& mesh) {
  std::error_code other;
  if (!output.empty() && std::filesystem::equivalent(output, mesh, other)) {
    throw HarnessError("--output '" + output +
                       "' is the mesh itself: distances go to a file of their own");
  }
}

// Vertex indices separated by white space or commas.
std::vector<Index> read_sources(const std::string& file) {
  std::string text = read_bytes(file);
  std::ranges::replace(text, ',', ' ');
  std::istringstream words(text);
  std::vector<Index> sources;
  for (std::string word; words >> word;) {
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), sources.emplace_back());
    if (error != std::errc() || end != word.data() + word.size()) {
      throw HarnessError("--sources-file '" + file + "': '" + excerpt(word) +
                         "' is not a vertex index");
    }
  }
  return sources;
}

void run_solve(SolveFlags flags) {
  if (flags.threads > 1 && !flags.each) {
    throw HarnessError("--threads is for --each: it solves several sources at a time");
  }
  if (flags.counters && flags.each) {
    throw HarnessError("--counters is for one solve: leave out --each");
  }
  if (flags.check && std::isfinite(flags.limit)) {
    throw HarnessError("--check is for distances without --limit");
  }
  if (!flags.sources_file.empty()) {
    const std::vector<Index> more = read_sources(flags.sources_file);
    flags.sources.insert(flags.sources.end(), more.begin(), more.end());
  }
  if (flags.sources.empty()) throw HarnessError("--source or --sources-file is required");
  const Description& solver = solver_named(flags.solver);
  if (flags.threads > 1 && !solver.abilities.concurrent_objects) {
    throw HarnessError(solver.name +
                       " cannot solve in several threads at the same time: leave out --threads");
  }
  set_instruction_set(instruction_set_named(flags.vectors));
  const MeshEntry entry = find_mesh(flags.mesh, flags.manifest);
  check_output(flags.output, entry.file);
  std::optional<AtomicFile> output;  // opened before the work: a bad path costs no solve
  const bool to_standard_output = flags.output == "-";
  if (!flags.output.empty() && !to_standard_output) output.emplace(flags.output);
  std::ostream* distances = to_standard_output ? &std::cout : output ? &output->stream() : nullptr;
  const TriangleSoup soup = load(flags, entry);
  const Mesh mesh(soup, Numbering::along_surface);
  const std::string unable = unsupported(solver, mesh);
  if (!unable.empty()) throw HarnessError(unable);

  const Problem problem{flags, solver, entry, soup, mesh};
  Json json{{"solver", solver.name},
            {"mesh", entry.name},
            {"vertices", mesh.vertex_count()},
            {"faces", mesh.face_count()},
            {"limit", std::isinf(flags.limit) ? Json(nullptr) : Json(flags.limit)}};
  json.update((flags.each ? solve_separately : solve_jointly)(problem, distances));
  if (output) output->commit();
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
                   "source vertex, 0-based, repeatable; distances are to the nearest source")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--sources-file", flags->sources_file,
                   "file of source vertices, separated by white space or commas")
      ->type_name("FILE");
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
      "  geodesic-bench solve bunny.ply --solver mmp --source 0,17,99 --each --threads 4");
  command->callback([flags] { run_solve(*flags); });
}

}  // namespace geodesic::harness
