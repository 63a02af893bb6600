#include "harness/rank/measure.h"

#include <algorithm>
#include <array>
#include <iostream>

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/cells/context.h"
#include "harness/cells/ending.h"
#include "harness/cells/folder.h"
#include "harness/cells/measure.h"
#include "harness/cells/progress.h"
#include "harness/measure/benchmark.h"
#include "harness/rank/figure.h"
#include "harness/rank/report.h"
#include "harness/results/row.h"
#include "harness/results/text_table.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

bool is_ok(const Json& row) { return row.at("outcome") == outcome::kOk; }

// Progress goes by the candidate's cells: each stands for all that is done on its source.
std::vector<Cell> cells_of_candidate(const Plan& plan) {
  std::vector<Cell> cells = plan.cells();
  std::erase_if(cells, [&](const Cell& cell) { return cell.solver != plan.solvers.front(); });
  return cells;
}

class Contest {
 public:
  Contest(const RankRequest& request, const Plan& plan, fs::path folder)
      : request_(request),
        plan_(plan),
        folder_(std::move(folder)),
        context_(run_context(request.suite, plan, request.command)),
        cells_(cells_of_candidate(plan)),
        progress_(cells_),
        references_(folder_ / "references", request.suite, [this](const std::string& solver) {
          progress_.working("reference by " + solver);
        }) {
    measured_.candidate = plan.solvers.front()->name;
    for (const Description* solver : plan.solvers) {
      if (solver != plan.solvers.front()) measured_.rivals.push_back(solver->name);
    }
    for (const PlannedMesh& mesh : plan.meshes) measured_.unfinished.push_back(mesh.entry.name);
  }

  RunResult run();

 private:
  MeasuredMesh measure(const PlannedMesh& mesh);
  MeasuredSource measure(const PlannedMesh& mesh, Index source);
  void time_pair(const PlannedMesh& mesh, MeasuredSource& measured, std::size_t rival, int pair);
  Json time_cell(const Cell& cell, const std::string& what);
  void write() const;

  const RankRequest& request_;
  const Plan& plan_;
  const fs::path folder_;
  const Json context_;
  const std::vector<Cell> cells_;
  Progress progress_;
  References references_;
  Measurements measured_;
  std::vector<Json> rows_;  // of all meshes so far
};

// One solve, warmed up and verified, in a process of its own.
Json Contest::time_cell(const Cell& cell, const std::string& what) {
  CellSpec spec = cell_spec(request_.suite, cell, folder_, request_.command);
  spec.counted = false;
  spec.output = folder_ / "pair.json";
  Json rows = measure_cell(cell, spec, references_, limits_of(request_.suite),
                           [&] { progress_.working(what); });
  fs::remove(spec.output);
  return std::move(rows.front());
}

// The candidate and the rival by turns: A B, B A, A B, ... so that neither always comes first. A
// solve that fails, though a first one was right, leaves its row.
// @param rival its number among the plan's solvers
void Contest::time_pair(const PlannedMesh& mesh, MeasuredSource& measured, std::size_t rival,
                        int pair) {
  const std::string what = "pair " + std::to_string(pair + 1) + " of " +
                           std::to_string(request_.pairs) + " against " +
                           plan_.solvers[rival]->name;
  std::array<std::size_t, 2> order{0, rival};
  if (pair % 2 == 1) std::swap(order[0], order[1]);
  double candidate_ms = 0, rival_ms = 0;
  for (const std::size_t solver : order) {
    Json row = time_cell({&mesh, measured.source, plan_.solvers[solver]}, what);
    if (!is_ok(row)) {
      measured.rows[solver] = std::move(row);
      return;
    }
    (solver == 0 ? candidate_ms : rival_ms) = row.at("cpu_time");
  }
  PairedTimes& pairs = measured.pairs[rival - 1];
  pairs.candidate_ms.push_back(candidate_ms);
  pairs.rival_ms.push_back(rival_ms);
}

MeasuredSource Contest::measure(const PlannedMesh& mesh, Index source) {
  MeasuredSource measured{.source = source};
  for (const Description* solver : plan_.solvers) {
    const Cell cell{&mesh, source, solver};
    const Json rows = measure_cell(cell, cell_spec(request_.suite, cell, folder_, request_.command),
                                   references_, limits_of(request_.suite),
                                   [&] { progress_.working("counting " + solver->name); });
    measured.rows.push_back(rows.front());
  }
  for (const std::string& rival : measured_.rivals) measured.pairs.push_back({.rival = rival});
  const auto can_time = [&](std::size_t rival) {
    return is_ok(measured.rows[0]) && is_ok(measured.rows[rival]);
  };
  for (int pair = 0; pair < request_.pairs; ++pair) {
    for (std::size_t rival = 1; rival < plan_.solvers.size(); ++rival) {
      if (can_time(rival)) time_pair(mesh, measured, rival, pair);
    }
  }
  for (std::size_t rival = plan_.solvers.size() - 1; rival > 0; --rival) {
    if (!can_time(rival))
      measured.pairs.erase(measured.pairs.begin() + static_cast<int>(rival) - 1);
  }
  return measured;
}

// "0.834 of mmp's time, 1.2 of ich's time"
std::string summary(const MeasuredSource& measured) {
  const Json& row = measured.rows.front();
  if (!is_ok(row)) {
    return row.at("outcome").get<std::string>() + ": " + row.at("error_message").get<std::string>();
  }
  std::vector<std::string> times;
  for (const PairedTimes& pairs : measured.pairs) {
    times.push_back(number(median(pairs.ratios()), "%.3f") + " of " + pairs.rival + "'s time");
  }
  return times.empty() ? "nothing to time it against" : join(times);
}

MeasuredMesh Contest::measure(const PlannedMesh& mesh) {
  MeasuredMesh measured{.mesh = mesh.entry.name, .vertices = mesh.vertices};
  for (const Index source : mesh.sources) {
    measured.sources.push_back(measure(mesh, source));
    progress_.ended(summary(measured.sources.back()));
  }
  return measured;
}

void Contest::write() const {
  const Ranking ranking = rank(measured_);
  write_result_file(folder_ / "rank.json", benchmark_context(), context_, rows_,
                    {{"ranking", to_json(ranking, measured_)}});
  write_bytes(folder_ / "rank.md", as_markdown(ranking, measured_));
  write_bytes(folder_ / "rank.tex", as_latex(ranking, measured_));
}

RunResult Contest::run() {
  for (const PlannedMesh& mesh : plan_.meshes) {
    measured_.meshes.push_back(measure(mesh));
    measured_.unfinished.erase(measured_.unfinished.begin());
    for (const MeasuredSource& source : measured_.meshes.back().sources) {
      for (const Json& row : source.rows) {
        rows_.push_back(row);
        rows_.back()["family_index"] = rows_.size() - 1;  // every cell's own file says 0
      }
    }
    write();
  }
  const RunResult result = tell_failures(rows_, plan_, request_.suite);
  std::cout << as_markdown(rank(measured_), measured_) << std::flush;
  if (request_.figure) std::cerr << draw_rank_figure(folder_) << '\n';
  std::cerr << (folder_ / "rank.md").string() << " (also .tex, .json)\n";
  return result;
}

}  // namespace

RunResult measure_ranking(RankRequest request) {
  check_suite(request.suite);
  set_memory_limit(request.suite, 1);
  const Plan plan = make_plan(request.suite, request.manifest);
  const std::string& candidate = plan.solvers.front()->name;
  const ResultFolder folder = ResultFolder::make(request.out, "ranks", candidate);
  folder.make_subfolders();
  return Contest(request, plan, folder.path()).run();
}

}  // namespace geodesic::harness
