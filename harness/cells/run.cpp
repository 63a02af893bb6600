#include "harness/cells/run.h"

#include <algorithm>
#include <iostream>

#include "harness/cells/context.h"
#include "harness/cells/failures.h"
#include "harness/cells/folder.h"
#include "harness/cells/measure.h"
#include "harness/cells/plan.h"
#include "harness/cells/progress.h"
#include "harness/cells/references.h"
#include "harness/cells/row.h"
#include "harness/cells/spec.h"
#include "harness/compare/statistics.h"
#include "harness/measure/benchmark.h"
#include "harness/results/context.h"
#include "harness/results/text_table.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

class Run {
 public:
  Run(const RunRequest& request, const Plan& plan, fs::path folder)
      : request_(request),
        plan_(plan),
        cells_(plan.cells()),
        folder_(std::move(folder)),
        progress_(cells_),
        references_(
            folder_ / "references", request.suite.reference,
            [this](const std::string& solver) { progress_.working("reference by " + solver); }) {}

  void measure();
  void assemble() const;
  RunResult conclude() const;

 private:
  void compute_references(std::size_t first);
  Json run_cell(const Cell& cell);

  const RunRequest& request_;
  const Plan& plan_;
  const std::vector<Cell> cells_;
  const fs::path folder_;
  const std::string started_ = utc_now();
  Progress progress_;
  References references_;
  std::vector<Json> rows_;  // of all cells so far
};

Json Run::run_cell(const Cell& cell) {
  CellSpec spec = cell_spec(request_.suite, cell, folder_, request_.command);
  spec.pictured = is_pictured(cell, request_.pictured);
  // Google Benchmark takes the last of several.
  spec.benchmark_flags.insert(spec.benchmark_flags.end(), request_.benchmark_flags.begin(),
                              request_.benchmark_flags.end());
  return measure_cell(cell, spec, references_, [this] { progress_.working("measuring"); });
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

void Run::measure() {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    compute_references(i);
    Json rows = run_cell(cells_[i]);
    progress_.ended(summary(rows));
    for (Json& row : rows) {
      row["family_index"] = i;  // every cell's own file says 0
      rows_.push_back(std::move(row));
    }
  }
}

void Run::assemble() const {
  Json whole = run_context(request_.suite, plan_, request_.command);
  whole["started"] = started_;
  write_result_file(folder_ / "run.json", benchmark_context(), whole, rows_);
}

RunResult Run::conclude() const {
  const RunResult result = tell_failures(rows_, plan_);
  const auto ok = std::count_if(rows_.begin(), rows_.end(), [](const Json& row) {
    return row.at("outcome") == outcome::kOk && row.at("repetition_index") == 0;
  });
  std::cerr << ok << " of " << cells_.size() << " cells ok\n";
  std::cout << (folder_ / "run.json").string() << std::endl;
  return result;
}

}  // namespace

RunResult run(const RunRequest& request) {
  check_suite(request.suite);
  check_benchmark_flags(request.benchmark_flags);
  const Plan plan = make_plan(request.suite, request.manifest);
  const fs::path folder = make_result_folder(request.out, "runs", request.suite.corpus);
  Run run(request, plan, folder);
  run.measure();
  run.assemble();
  return run.conclude();
}

}  // namespace geodesic::harness
