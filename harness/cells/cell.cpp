#include "harness/cells/cell.h"

#include <memory>

#include "harness/base/clock.h"
#include "harness/corpus/vectors.h"
#include "harness/measure/benchmark.h"
#include "harness/measure/recorded_solve.h"
#include "harness/recordings/files.h"
#include "harness/recordings/folders.h"
#include "harness/recordings/isolines/solve.h"
#include "harness/results/row.h"
#include "harness/verify/choose.h"
#include "harness/verify/distance_file.h"
#include "harness/verify/verify.h"
#include "meshes/load.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

class Measurement {
 public:
  Measurement(const CellSpec& spec, const TriangleSoup& soup, const Mesh& mesh)
      : spec_(spec),
        soup_(soup),
        mesh_(mesh),
        query_{.sources = {{.vertex = spec.source}}},
        verified_(mesh.vertex_count()),
        solved_(mesh.vertex_count()) {}

  Timing measure();

 private:
  std::string verify_warm_up(Solver& solver);
  const Description& description() const { return *find_solver(spec_.solver); }
  Json record();
  void record_isolines(const std::filesystem::path& folder);

  const CellSpec& spec_;
  const TriangleSoup& soup_;
  const Mesh& mesh_;
  const Query query_;
  std::vector<double> verified_;  // distances of the warm-up solve
  std::vector<double> solved_;    // of the solve that came last
  double max_relative_error_ = 0;
};

std::vector<double> solve_once(const std::string& solver, const Mesh& mesh, const Query& query) {
  std::vector<double> distances(mesh.vertex_count());
  make_solver(solver, mesh)->solve(query, distances);
  return distances;
}

// Empty when the distances are right. Leaves them in verified_.
std::string Measurement::verify_warm_up(Solver& solver) {
  solver.solve(query_, verified_);
  const std::vector<double> reference = read_distances(spec_.reference_file, mesh_.vertex_count());
  std::vector<double> bound;
  std::optional<Distances> edge_graph;
  if (const Description* chosen = choose_upper_bound(registered_solvers())) {
    bound = solve_once(chosen->name, mesh_, query_);
    edge_graph = {chosen->name, bound};
  }
  const Verdict verdict = verify(mesh_, std::vector{spec_.source}, description().exactness,
                                 verified_, {spec_.reference, reference}, edge_graph);
  max_relative_error_ = verdict.max_relative_error;
  return verdict.error;
}

// What to say of it in the rows: where it is, or why it is not there. A full disk takes no time
// away that was measured.
Json Measurement::record() {
  Recording recording = wavefront_wish();
  make_solver(spec_.solver, mesh_)->solve(query_, solved_, &recording);
  const RecordingFolders folders = recording_folders(spec_.mesh, spec_.source, spec_.solver);
  const std::filesystem::path run = spec_.run_folder;
  try {
    write_surface(run / folders.mesh, soup_);
    if (description().exactness == Exactness::exact)
      write_vertex_distances(run / folders.source, verified_);
    write_wavefront(run / folders.solver, mesh_, recording);
    if (description().final_windows && !has_isolines(run / folders.source))
      record_isolines(run / folders.source);
  } catch (const std::exception& error) {
    return {{"recordings_error", error.what()}};
  }
  return {{"recordings", folders.solver.string()}};
}

// The first solver that can does it for all of this source.
void Measurement::record_isolines(const std::filesystem::path& folder) {
  std::vector<double> distances = verified_;
  const std::vector<double> levels = isoline_levels(verified_, wavefront_wish().snapshots_at);
  write_isolines(folder, solve_isolines(spec_.solver, mesh_, query_, levels, distances));
  if (!identical(distances, verified_)) solved_ = distances;
}

Timing Measurement::measure() {
  const auto wrong = [&](const std::string& why) -> Timing {
    return {benchmark_context(),
            {error_row(spec_.solver, spec_.mesh, spec_.source, outcome::kWrongAnswer, why)}};
  };
  const Stopwatch preparation;
  std::unique_ptr<Solver> solver = make_solver(spec_.solver, mesh_);
  const double prepare_ms = 1e3 * preparation.cpu_seconds();

  const std::string error = verify_warm_up(*solver);
  if (!error.empty()) return wrong(error);
  Timing timing = time_repetitions(row_name(spec_.solver, spec_.mesh, spec_.source),
                                   spec_.benchmark_flags, [&] { solver->solve(query_, solved_); });
  if (!identical(solved_, verified_))
    return wrong("a timed solve gave other distances than the first one");
  const auto resident = peak_resident_bytes();
  const std::string_view instructions = name_of(solver->instruction_set());
  solver.reset();

  Json recorded = Json::object();
  if (spec_.counted) recorded = record_solve(spec_.solver, mesh_, query_, solved_);
  if (spec_.pictured && recorded.contains("wavefront_sd") && identical(solved_, verified_))
    recorded.update(record());
  if (!identical(solved_, verified_))
    return wrong("a recorded solve gave other distances than timed ones");
  for (Json& row : timing.rows) {
    row.update({{"solver", spec_.solver},
                {"mesh", spec_.mesh},
                {"source", spec_.source},
                {"outcome", outcome::kOk},
                {"instruction_set", instructions},
                {"prepare_time", prepare_ms}});
    row.update(recorded);
    if (resident) row["process_peak_bytes"] = *resident;
    row["max_relative_error"] = max_relative_error_;
    row["reference"] = spec_.reference;
  }
  return timing;
}

}  // namespace

void run_cell(const CellSpec& spec) {
  set_instruction_set(instruction_set_named(spec.vectors));
  const TriangleSoup soup = load_mesh(spec.mesh_file).soup;
  const Stopwatch building;
  const Mesh mesh(soup, Numbering::along_surface);
  const double mesh_ms = 1e3 * building.cpu_seconds();
  restart_peak_resident_bytes();
  Timing timing = Measurement(spec, soup, mesh).measure();
  for (Json& row : timing.rows) {
    if (row.at("outcome") == outcome::kOk) row["mesh_time"] = mesh_ms;
  }
  write_result_file(spec.output, timing.context, spec.context, timing.rows);
}

void run_reference(const ReferenceSpec& spec) {
  const Mesh mesh(load_mesh(spec.mesh_file).soup, Numbering::along_surface);
  write_distances(spec.output,
                  solve_once(spec.solver, mesh, {.sources = {{.vertex = spec.source}}}));
}

}  // namespace geodesic::harness
