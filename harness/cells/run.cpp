#include "harness/cells/run.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "harness/base/atomic_file.h"
#include "harness/base/command_line.h"
#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/cells/context.h"
#include "harness/cells/ending.h"
#include "harness/cells/failures.h"
#include "harness/cells/folder.h"
#include "harness/cells/kept.h"
#include "harness/cells/measure.h"
#include "harness/cells/plan.h"
#include "harness/cells/programs.h"
#include "harness/cells/progress.h"
#include "harness/cells/references.h"
#include "harness/cells/spec.h"
#include "harness/compare/statistics.h"
#include "harness/measure/benchmark.h"
#include "harness/results/context.h"
#include "harness/results/row.h"
#include "harness/results/text_table.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

class Run {
 public:
  Run(const SavedRequest& saved, const Plan& plan, fs::path folder)
      : saved_(saved),
        request_(saved.request),
        plan_(plan),
        cells_(request_.interleave ? plan.interleaved_cells(request_.suite.repetitions)
                                   : plan.cells()),
        folder_(std::move(folder)),
        progress_(cells_),
        references_(folder_ / "references", request_.suite, [this](const std::string& solver) {
          progress_.working("reference by " + solver);
        }) {}

  /// Takes over what the folder holds of an earlier start.
  void keep();
  void measure();
  void assemble() const;
  RunResult conclude() const;
  /// What is safe, and the command that does the rest.
  void tell_how_to_go_on() const;

 private:
  CellSpec spec_of(const Cell& cell) const;
  void compute_references(std::size_t first);
  Json rows_of(std::size_t cell);
  Json run_cell(const Cell& cell);
  void note_failure(const Cell& cell, const Json& row);

  const SavedRequest& saved_;
  const RunRequest& request_;
  const Plan& plan_;
  const std::vector<Cell> cells_;
  const fs::path folder_;
  Progress progress_;
  References references_;
  std::map<std::size_t, Json> kept_;  // rows by cell
  std::size_t measured_ = 0;          // cells
  std::vector<Json> rows_;            // of all cells so far
  std::size_t ok_ = 0;                // cells
  // The first source that took all its memory or time, and what that was.
  std::map<std::tuple<const MeasuredProgram*, const Description*, const PlannedMesh*>, std::string>
      exhausted_;
  std::set<std::pair<const MeasuredProgram*, std::string>> failed_;  // names of cells
};

CellSpec Run::spec_of(const Cell& cell) const {
  CellSpec spec = cell_spec(request_.suite, cell, folder_, request_.command);
  spec.pictured = is_pictured(cell, request_.pictured) &&
                  (cell.program == nullptr || cell.program == &plan_.programs.front());
  // Google Benchmark takes the last of several.
  spec.benchmark_flags.insert(spec.benchmark_flags.end(), request_.benchmark_flags.begin(),
                              request_.benchmark_flags.end());
  return spec;
}

void Run::keep() {
  remove_parts_of_files(folder_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (std::optional<Json> rows = kept_rows(cells_[i], spec_of(cells_[i])))
      kept_[i] = std::move(*rows);
  }
  std::cerr << kept_.size() << " of " << cells_.size() << " cells are kept from "
            << folder_.string() << '\n';
}

Json Run::run_cell(const Cell& cell) {
  const CellSpec spec = spec_of(cell);
  const auto exhausted = exhausted_.find({cell.program, cell.solver, cell.mesh});
  if (exhausted != exhausted_.end()) {
    write_failure(cell, spec, outcome::kSkipped, exhausted->second);
    return read_json(spec.output).at("benchmarks");
  }
  return measure_cell(cell, spec, references_, limits_of(request_.suite),
                      [this] { progress_.working("measuring"); });
}

// Other repetitions would fail as well, and other sources of the mesh take all memory or time.
void Run::note_failure(const Cell& cell, const Json& row) {
  const std::string outcome = row.at("outcome");
  if (outcome != outcome::kOk) failed_.insert({cell.program, cell.name()});
  if (outcome != outcome::kOutOfMemory && outcome != outcome::kTimeOut) return;
  exhausted_.try_emplace({cell.program, cell.solver, cell.mesh},
                         outcome + " from source " + std::to_string(cell.source));
}

// "ok  12.3 ms", "wrong answer: vertex 7 has ..."
std::string summary(const Json& rows) {
  const std::string outcome = rows.front().at("outcome");
  if (outcome != outcome::kOk) {
    return outcome + ": " + rows.front().at("error_message").get<std::string>();
  }
  std::vector<double> times;
  for (const Json& row : rows) times.push_back(row.at("cpu_time"));
  return outcome + "  " + number(median(times)) + " ms";
}

// Those of the mesh whose first cell this is. Without threads they are computed when they are
// needed, which lets a run show its first time sooner.
void Run::compute_references(std::size_t first) {
  const PlannedMesh* mesh = cells_[first].mesh;
  if (request_.threads == 1 || (first > 0 && cells_[first - 1].mesh == mesh)) return;
  std::size_t last = first;
  while (last < cells_.size() && cells_[last].mesh == mesh) ++last;
  references_.compute_ahead(std::span(cells_).subspan(first, last - first), request_.threads);
}

Json Run::rows_of(std::size_t cell) {
  const auto kept = kept_.find(cell);
  if (kept != kept_.end()) {
    progress_.kept();
    return kept->second;
  }
  compute_references(cell);
  Json rows = run_cell(cells_[cell]);
  ++measured_;
  progress_.ended(summary(rows));
  return rows;
}

void Run::measure() {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    throw_if_interrupted();
    if (failed_.contains({cells_[i].program, cells_[i].name()})) {
      progress_.left_out();
      continue;
    }
    Json rows = rows_of(i);
    note_failure(cells_[i], rows.front());
    if (rows.front().at("outcome") == outcome::kOk) ++ok_;
    for (Json& row : rows) {
      row["family_index"] = i;  // every cell's own file says 0
      rows_.push_back(std::move(row));
    }
  }
}

void Run::tell_how_to_go_on() const {
  const std::string folder = fs::absolute(folder_).string();
  std::cerr << "\n"
            << kept_.size() + measured_ << " of " << cells_.size() << " cells are saved in "
            << folder << "; to measure the others:\n  "
            << as_command_line({"run", "--resume", folder}) << std::endl;
}

void Run::assemble() const {
  Json whole = run_context(request_.suite, plan_, request_.command);
  whole["started"] = saved_.started;
  if (request_.interleave) whole["interleaved"] = true;
  for (const MeasuredProgram& program : plan_.programs) whole["programs"].push_back(program.facts);
  if (!saved_.changes.empty()) whole["changes"] = saved_.changes;
  write_result_file(folder_ / "run.json", benchmark_context(), whole, rows_);
}

RunResult Run::conclude() const {
  const RunResult result = tell_failures(rows_, plan_, request_.suite);
  std::cerr << ok_ << " of " << cells_.size() << " cells ok\n";
  std::cout << (folder_ / "run.json").string() << std::endl;
  return result;
}

// What changed since the run began, unless that is accepted.
void compare_with(const Json& before, SavedRequest& saved) {
  const std::vector<std::string> changes = differences(before, saved.identity);
  if (changes.empty()) return;
  if (!saved.request.accept_changes) {
    throw HarnessError("cannot go on with the run in '" + saved.request.resume->string() +
                       "': " + join(changes, "; ") +
                       ": start a run of its own, or mix both results with --accept-changes");
  }
  for (const std::string& change : changes) std::cerr << "accepted: " << change << '\n';
  saved.changes.insert(saved.changes.end(), changes.begin(), changes.end());
}

// A run that is gone on with stays the one that it was.
SavedRequest saved_now(const RunRequest& request, const Plan& plan) {
  SavedRequest saved{request, identity(request, plan), utc_now(), {}};
  if (request.resume) {
    const SavedRequest before = saved_request(*request.resume);
    saved.started = before.started;
    saved.changes = before.changes;
    saved.request.command = before.request.command;
    compare_with(before.identity, saved);
  }
  return saved;
}

}  // namespace

RunResult run(RunRequest request) {
  check_suite(request.suite);
  check_benchmark_flags(request.benchmark_flags);
  check_programs(request.programs);
  if (!request.programs.empty()) request.interleave = true;
  set_memory_limit(request.suite, request.threads);
  Plan plan = make_plan(request.suite, request.manifest, request.cells);
  const ResultFolder folder = request.resume
                                  ? ResultFolder(*request.resume)
                                  : ResultFolder::make(request.out, "runs", request.suite.corpus);
  const SavedRequest saved = saved_now(request, plan);
  save_request(saved, folder.path());
  folder.make_subfolders();

  const InterruptionGuard guard;
  plan.programs = measured_programs(request.programs, folder.path());
  Run run(saved, plan, folder.path());
  if (request.resume) run.keep();
  try {
    run.measure();
    run.assemble();
  } catch (const std::exception&) {
    run.tell_how_to_go_on();
    throw;
  }
  return run.conclude();
}

}  // namespace geodesic::harness
