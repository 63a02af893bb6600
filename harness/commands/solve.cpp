#include "harness/commands/solve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/vectors.h"
#include "harness/error.h"
#include "harness/measure/process.h"
#include "harness/measure/recorded_solve.h"
#include "harness/meshes/load.h"
#include "harness/results/atomic_file.h"
#include "harness/results/counters.h"
#include "harness/verify/closed_form.h"
#include "harness/verify/verify.h"
#include "solvers/registry.h"

namespace geodesic::harness {
namespace {

struct SolveFlags {
  std::string mesh, solver;
  std::vector<Index> sources;
  std::string output;
  bool repair = false;
  double limit = kInfinity;
  std::string vectors = kAutoVectors;
  std::string manifest = default_manifest().string();
};

// One distance a line in file order, 17 significant digits: every double survives.
void write_text(std::ostream& out, std::span<const double> distances) {
  char line[40];
  for (const double d : distances) {
    std::snprintf(line, sizeof line, "%.17g\n", d);
    out << (std::isinf(d) ? "inf\n" : line);
  }
}

void warn(const std::string& warning) { std::cerr << "geodesic-bench: " << warning << '\n'; }

TriangleSoup load(const SolveFlags& flags, const MeshEntry& entry) {
  LoadedMesh loaded = load_mesh(entry.file, {.repair = flags.repair});
  for (const std::string& warning : loaded.warnings) warn(entry.file.string() + ": " + warning);
  return std::move(loaded.soup);
}

Query query_of(const SolveFlags& flags) {
  Query query{.sources = {}, .limit = flags.limit};
  for (const Index v : flags.sources) query.sources.push_back({.vertex = v});
  return query;
}

struct Solved {
  std::vector<double> distances;
  Json json;
};

Solved solve(const SolveFlags& flags, const Description& solver, const Mesh& mesh) {
  const Query query = query_of(flags);
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
  for (const std::string& name : counter_names()) solved.json[name] = nullptr;
  const auto resident = peak_resident_bytes();
  prepared.reset();

  std::vector<double> recorded(mesh.vertex_count());
  solved.json.update(record_solve(solver.name, mesh, query, recorded));
  solved.json["process_peak_bytes"] = resident ? Json(*resident) : Json(nullptr);
  if (!identical(recorded, solved.distances)) {
    throw WrongAnswer(solver.name + ": a recorded solve gave other distances than the timed one");
  }
  return solved;
}

// The closed form's distances from the nearest of the sources; nothing where it is not known.
std::optional<std::vector<double>> known_distances(const SolveFlags& flags, const MeshEntry& entry,
                                                   const TriangleSoup& soup) {
  if (std::isfinite(flags.limit)) return std::nullopt;
  std::optional<std::vector<double>> least;
  try {
    for (const Index source : flags.sources) {
      const auto known = closed_form_distances(entry, soup, source);
      if (!known) return std::nullopt;
      if (!least) least.emplace(known->size(), kInfinity);
      for (std::size_t v = 0; v < known->size(); ++v) {
        (*least)[v] = std::min((*least)[v], (*known)[v]);
      }
    }
  } catch (const HarnessError& error) {
    warn(error.what());
    return std::nullopt;
  }
  return least;
}

// What the distances were compared with, and how far they are from it. @throws WrongAnswer
Json verify_by(const std::optional<std::vector<double>>& known, const SolveFlags& flags,
               const Description& solver, const Mesh& mesh, const std::vector<double>& distances) {
  if (!known) return {{"reference", nullptr}, {"max_relative_error", nullptr}};
  const Verdict verdict =
      verify(mesh, flags.sources, solver.exactness, distances, {kClosedForm, *known}, std::nullopt);
  if (!verdict.error.empty()) throw WrongAnswer(solver.name + ": " + verdict.error);
  return {{"reference", kClosedForm}, {"max_relative_error", verdict.max_relative_error}};
}

void run_solve(const SolveFlags& flags) {
  const Description& solver = solver_named(flags.solver);
  set_instruction_set(instruction_set_named(flags.vectors));
  const MeshEntry entry = find_mesh(flags.mesh, flags.manifest);
  std::optional<AtomicFile> output;  // opened before the work: a bad path costs no solve
  if (!flags.output.empty()) output.emplace(flags.output);
  const TriangleSoup soup = load(flags, entry);
  const Mesh mesh(soup, Numbering::along_surface);
  const std::string unable = unsupported(solver, mesh);
  if (!unable.empty()) throw HarnessError(unable);

  Solved solved = solve(flags, solver, mesh);
  solved.json.update(
      verify_by(known_distances(flags, entry, soup), flags, solver, mesh, solved.distances));
  if (output) {
    write_text(output->stream(), solved.distances);
    output->commit();
  }
  Json json{{"solver", solver.name},
            {"mesh", entry.name},
            {"vertices", mesh.vertex_count()},
            {"faces", mesh.face_count()},
            {"sources", flags.sources},
            {"limit", std::isinf(flags.limit) ? Json(nullptr) : Json(flags.limit)}};
  json.update(solved.json);
  std::cout << json.dump(2) << std::endl;
}

}  // namespace

void add_solve_command(CLI::App& app) {
  const auto flags = std::make_shared<SolveFlags>();
  CLI::App* command =
      app.add_subcommand("solve", "Solve once: numbers as JSON, distances in a file");
  command->add_option("mesh", flags->mesh, "a file, or a mesh of the manifest")
      ->required()
      ->type_name("MESH");
  command->add_option("--solver", flags->solver, "its name (geodesic-bench list)")->required();
  command->add_option("--source", flags->sources, "a vertex, counted from 0; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--output", flags->output, "file for the distances, one a line");
  command->add_flag("--repair", flags->repair, "mend defects of the mesh, and say which");
  command->add_option("--limit", flags->limit, "vertices farther than this are unreachable");
  command->add_option("--vectors", flags->vectors,
                      "instructions to solve with: auto, plain or avx2");
  command->add_option("--manifest", flags->manifest, "list of meshes and corpora");
  command->callback([flags] { run_solve(*flags); });
}

}  // namespace geodesic::harness
