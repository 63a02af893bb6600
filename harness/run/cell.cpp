#include "harness/run/cell.h"

#include <iostream>
#include <memory>
#include <new>

#include "harness/base/clock.h"
#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/external/external_solver.h"
#include "harness/measure/benchmark.h"
#include "harness/measure/path_measurement.h"
#include "harness/measure/recorded_solve.h"
#include "harness/recordings/files.h"
#include "harness/run/further_sources.h"
#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"
#include "meshes/load.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

// Exit codes of cells and references, in addition to 0 and 1. The program uses 2 for wrong answers.
constexpr int kOutOfMemory = 3;
constexpr int kCannotWrite = 4;

void note(const RelativeErrors& errors, Row& row) {
  row.max_relative_error = errors.max;
  row.mean_relative_error = errors.mean;
  row.rms_relative_error = errors.rms;
  row.p99_relative_error = errors.p99;
  row.unreachable_mismatches = errors.unreachable_mismatches;
}

// The sources of a CellSpec or a ReferenceSpec.
template <class Spec>
SourceSet sources_of(const Spec& spec) {
  SourceSet sources = single_source(spec.source);
  if (!spec.sources_file.empty()) sources.vertices = read_source_vertices(spec.sources_file);
  return sources;
}

// The times of the last solve. An external program gives no other data.
void note(const ExternalSolver::Times& times, Row& row) {
  row.timed = times.of;
  row.prepare_time = 1e3 * times.prepare;
  row.process_peak_bytes = times.peak_bytes;
  row.instruction_set.reset();
}

class Measurement {
 public:
  Measurement(const CellSpec& spec, const TriangleSoup& soup, const Mesh& mesh)
      : spec_(spec),
        solver_(*find_solver(spec.solver)),
        soup_(soup),
        mesh_(mesh),
        sources_(sources_of(spec)),
        query_(sources_.query()),
        verified_(mesh.vertex_count()),
        solved_(mesh.vertex_count()) {
    row_.solver = spec.solver;
    row_.threads = solver_.thread_count();
    row_.mesh = spec.mesh;
    row_.source = spec.source_set.empty() ? sources_.name : spec.source_set;
  }

  /// @param mesh_ms milliseconds that building the mesh took
  std::vector<Row> run(double mesh_ms);

 private:
  // Returns why the distances are wrong; empty when they are right. Times solves and fills in the
  // row only in that case.
  std::string measure();
  // CPU time, or real time if several threads share the work.
  double seconds(const Stopwatch& watch) const;
  void time(Solver& solver);
  std::string verify_warm_up(Solver& solver);
  std::string verify_after_others(Solver& solver);
  Verdict judge(std::span<const double> distances) const;
  // Returns why the last distances are wrong, if those of the first solve are right.
  // @param which message if the solver is deterministic
  std::string verify_again(const std::string& which);
  // Returns why an answer from a further source is wrong; empty when all are right.
  std::string solve_further(Solver& solver);
  void count();
  void measure_paths();
  void record();
  void record_paths(const std::filesystem::path& folder);
  const CellSpec& spec_;
  const Description& solver_;
  const TriangleSoup& soup_;
  const Mesh& mesh_;
  const SourceSet sources_;
  const Query query_;
  std::vector<double> verified_;  // distances of the warm-up solve
  std::vector<double> solved_;    // distances of the last solve
  std::vector<Repetition> repetitions_;
  Row row_;     // the values that all repetitions share
  Row failed_;  // the row to write when the distances are wrong
};

Verdict Measurement::judge(std::span<const double> distances) const {
  const std::vector<double> reference = read_distances(spec_.reference_file, mesh_.vertex_count());
  std::vector<double> bound;
  std::optional<NamedDistances> edge_graph;
  if (const Description* chosen = choose_upper_bound(registered_solvers())) {
    bound = solve_once(chosen->name, mesh_, query_);
    edge_graph = {chosen->name, bound};
  }
  return verify_distances(mesh_, query_, Promise::of(solver_), distances,
                          {spec_.reference, reference}, edge_graph);
}

std::string Measurement::verify_warm_up(Solver& solver) {
  solver.solve(query_, verified_);
  const auto [error, errors] = judge(verified_);
  row_.reference = spec_.reference;
  note(errors, row_);
  failed_ = row_;
  return error;
}

std::string Measurement::verify_again(const std::string& which) {
  if (solver_.deterministic && identical(solved_, verified_)) return {};
  const auto [error, errors] = judge(solved_);
  note(errors, failed_);
  return solver_.deterministic ? which : error;
}

// Earlier solves of an object must not change its answers.
std::string Measurement::verify_after_others(Solver& solver) {
  const auto solve = [&](const Query& query) {
    if (solver_.needs_renewal) solver.renew();
    solver.solve(query, solved_);
  };
  const auto others = static_cast<Index>(spec_.other_queries);
  for (Index k = 1; k <= others; ++k) {
    const auto step = static_cast<Index>(std::uint64_t{k} * mesh_.vertex_count() / (others + 1));
    Query other = query_;
    for (Source& source : other.sources) {
      source.at = (source.at.vertex + step) % mesh_.vertex_count();
    }
    solve(other);
  }
  if (others > 0) solve(query_);
  return others == 0 ? ""
                     : verify_again("after " + std::to_string(others) +
                                    " other sources the same object gave other distances");
}

// An external program says the time of its last solve only: its answers are not timed here.
std::string Measurement::solve_further(Solver& solver) {
  if (spec_.further_sources.empty() || dynamic_cast<ExternalSolver*>(&solver) != nullptr) return {};
  const std::vector<Index> sources = read_source_vertices(spec_.further_sources);
  std::optional<DistanceRows> exact;
  if (!spec_.further_reference.empty()) {
    exact.emplace(spec_.further_reference_file, sources.size(), mesh_.vertex_count());
  }
  auto [times, errors, wrong] = solve_further_sources(solver, sources, exact ? &*exact : nullptr);
  row_.further = times;
  row_.further_errors = std::move(errors);
  if (row_.further_errors) row_.further_errors->reference = spec_.further_reference;
  return wrong;
}

void Measurement::count() {
  const RecordedSolve recorded = record_solve(spec_.solver, mesh_, query_, solved_);
  row_.counters = recorded.counters;
  row_.phase_seconds = recorded.phases;
  row_.solver_peak_bytes = recorded.peak_bytes;
  row_.unreachable_vertices = unreachable_vertices(solved_);
}

// Paths from a single source only: a code that solves from one source after the other may keep only
// the data of the last one.
void Measurement::measure_paths() {
  const Abilities& can = solver_.abilities;
  if (spec_.path_targets == 0 || !spec_.source_set.empty() || !(can.paths || can.traces)) return;
  row_.paths = harness::measure_paths(solver_, mesh_, spec_.source,
                                      static_cast<std::size_t>(spec_.path_targets),
                                      read_distances(spec_.reference_file, mesh_.vertex_count()));
}

// Writes the data for figures: the wavefront, if the solver has one, and the distances. All exact
// solvers of a source share the distances; an inexact solver has its own. After an error, such as a
// full disk, the measured times are kept.
void Measurement::record() {
  const bool has_wavefront = row_.counters.wavefront_sd.has_value();
  const bool exact = solver_.exactness == Exactness::exact;
  if (exact && !has_wavefront) return;
  Recording recording = wavefront_recording(spec_.frames);
  if (has_wavefront) make_solver(spec_.solver, mesh_)->solve(query_, solved_, &recording);
  const RecordingFolders folders = recording_folders(spec_.mesh, row_.source, spec_.solver);
  const std::filesystem::path run = spec_.run_folder;
  try {
    write_surface(run / folders.mesh, soup_);
    write_vertex_distances(run / (exact ? folders.source : folders.solver), verified_);
    if (has_wavefront) write_wavefront(run / folders.solver, mesh_, recording);
    if (exact && solver_.abilities.paths) record_paths(run / folders.source);
    row_.recordings = folders.solver.string();
  } catch (const std::exception& error) {
    row_.recordings_error = error.what();
  }
}

// Written by the first solver of the source that supports paths.
void Measurement::record_paths(const std::filesystem::path& folder) {
  if (!has_paths(folder)) {
    std::vector<double> distances = verified_;
    write_paths(folder, solve_figure_paths(spec_.solver, mesh_, query_, distances));
    if (!identical(distances, verified_)) solved_ = distances;
  }
  if (solver_.abilities.multiple_sources && !has_cells(folder)) {
    const auto sources = spec_.source_set.empty()
                             ? spread_vertices(mesh_, spec_.source, kFigureSources, verified_)
                             : sources_.vertices;
    write_cells(folder, solve_figure_cells(spec_.solver, mesh_, sources));
  }
}

double Measurement::seconds(const Stopwatch& watch) const {
  return row_.threads > 1 ? watch.real_seconds() : watch.cpu_seconds();
}

// Times solves by the verified object.
void Measurement::time(Solver& solver) {
  double renewing = 0;
  int renewals = 0;
  TimedWork work{.solve = [&] { solver.solve(query_, solved_); },
                 .several_threads = row_.threads > 1};
  if (solver_.needs_renewal) {
    work.prepare = [&] {
      const Stopwatch watch;
      solver.renew();
      renewing += seconds(watch);
      ++renewals;
    };
  }
  if (const auto* external = dynamic_cast<const ExternalSolver*>(&solver)) {
    work.elsewhere = [external] {
      return SecondsElsewhere{external->last().real, external->last().cpu};
    };
  }
  repetitions_ = time_repetitions(spec_.benchmark_flags, work);
  if (renewals > 0) row_.renew_time = 1e3 * renewing / renewals;
}

std::string Measurement::measure() {
  const Stopwatch preparation;
  std::unique_ptr<Solver> solver = make_solver(spec_.solver, mesh_);
  const double preparing = seconds(preparation);
  if (std::string error = verify_warm_up(*solver); !error.empty()) return error;
  row_.prepare_time = 1e3 * preparing;
  std::string error = verify_after_others(*solver);
  if (!error.empty()) return error;
  time(*solver);
  error = verify_again("a timed solve gave other distances than the first one");
  if (!error.empty()) return error;
  error = solve_further(*solver);
  if (!error.empty()) return error;
  row_.process_peak_bytes = peak_resident_bytes();
  row_.instruction_set = name_of(solver->instruction_set());
  row_.certificate = solver->certificate();
  const auto* external = dynamic_cast<const ExternalSolver*>(solver.get());
  if (external != nullptr) {
    note(external->last(), row_);
    row_.unreachable_vertices = unreachable_vertices(solved_);
  }
  const bool has_counters = external == nullptr;
  solver.reset();

  if (spec_.with_counters && has_counters) count();
  if (spec_.with_counters) measure_paths();
  const bool same = identical(solved_, verified_) || !solver_.deterministic;
  if (spec_.with_recordings && same) record();
  return verify_again("a recorded solve gave other distances than timed ones");
}

std::vector<Row> Measurement::run(double mesh_ms) {
  failed_ = row_;
  const std::string wrong = measure();
  if (!wrong.empty()) {
    failed_.outcome = Outcome::wrong_answer;
    failed_.error_message = wrong;
    return {failed_};
  }
  std::vector<Row> rows;
  row_.mesh_time = mesh_ms;
  row_.repetitions = static_cast<int>(repetitions_.size());
  for (const Repetition& repetition : repetitions_) {
    row_.repetition_index = static_cast<int>(rows.size());
    row_.iterations = repetition.iterations;
    row_.real_time = repetition.real_ms;
    row_.cpu_time = repetition.cpu_ms;
    rows.push_back(row_);
  }
  return rows;
}

}  // namespace

void run_cell(const CellSpec& spec) {
  set_instruction_set(instruction_set_named(spec.vectors));
  const TriangleSoup soup = load_mesh(spec.mesh_file, {.repair = spec.repair}).soup;
  const Stopwatch building;
  const Mesh mesh(soup, Numbering::along_surface);
  const double mesh_ms = 1e3 * building.cpu_seconds();
  restart_peak_resident_bytes();
  write_json(spec.output, {{"benchmarks", Measurement(spec, soup, mesh).run(mesh_ms)}});
}

void run_reference(const ReferenceSpec& spec) {
  const Mesh mesh(load_mesh(spec.mesh_file, {.repair = spec.repair}).soup,
                  Numbering::along_surface);
  const SourceSet sources = sources_of(spec);
  if (!spec.each) {
    write_distances(spec.output, solve_once(spec.solver, mesh, sources.query()));
    return;
  }
  AtomicFile file(spec.output);
  const std::unique_ptr<Solver> solver = make_solver(spec.solver, mesh);
  for (const Index v : sources.vertices) {
    write_distances(file.stream(), solve_with(*solver, mesh, query_from({v})));
  }
  file.commit();
}

int exit_code_of(const std::function<void()>& work) {
  try {
    work();
    return 0;
  } catch (const std::bad_alloc& error) {
    std::cerr << "no memory left" << std::endl;
    return kOutOfMemory;
  } catch (const CannotWrite& error) {
    std::cerr << error.what() << std::endl;
    return kCannotWrite;
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}

Failure failure_of(const Ended& ended, const ProcessLimits& limits) {
  if (ended.timed_out) {
    return {Outcome::time_out, "not finished after " + significant(limits.seconds, 6) +
                                   " s (time limit)" +
                                   (ended.error_lines.empty() ? "" : ": " + ended.error_lines)};
  }
  if (!ended.crashed && ended.code == kCannotWrite) throw CannotWrite(ended.error_lines);
  if (ended.out_of_memory || (!ended.crashed && ended.code == kOutOfMemory)) {
    const std::string limit =
        limits.memory_bytes == ProcessLimits().memory_bytes
            ? "no memory left"
            : "memory limit " + std::to_string(limits.memory_bytes >> 20) + " MiB";
    return {Outcome::out_of_memory, ended.crashed ? limit + ", " + ended.describe() : limit};
  }
  return {ended.crashed ? Outcome::crashed : Outcome::error, ended.describe()};
}

}  // namespace geodesic::harness
