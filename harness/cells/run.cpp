#include "harness/cells/run.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "harness/cells/plan.h"
#include "harness/cells/process.h"
#include "harness/cells/progress.h"
#include "harness/cells/references.h"
#include "harness/cells/row.h"
#include "harness/cells/spec.h"
#include "harness/error.h"
#include "harness/folders.h"
#include "harness/measure/benchmark.h"
#include "harness/results/atomic_file.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Raw results never change: a folder that holds some is not written to again.
fs::path make_run_folder(const RunRequest& request) {
  fs::path folder;
  if (request.out) {
    folder = *request.out;
  } else {
    std::string time = utc_now();
    std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
    folder = runs_folder() / (time + "-" + request.suite.corpus);
  }
  if (fs::exists(folder / "run.json") || fs::exists(folder / "cells")) {
    throw HarnessError("'" + folder.string() +
                       "' holds a run already: remove it, or give another folder with --out");
  }
  std::error_code error;
  fs::create_directories(folder / "cells", error);
  if (!error) fs::create_directories(folder / "references", error);
  if (error) {
    throw HarnessError("cannot make the folder '" + folder.string() + "': " + error.message());
  }
  return folder;
}

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
  void start_cell(const Cell& cell, const fs::path& file);
  Json context(const std::vector<const PlannedMesh*>& meshes,
               const std::vector<const Description*>& solvers) const;
  Json cell_context(const Cell& cell) const;
  std::vector<std::string> benchmark_flags() const;
  void write_error(const Cell& cell, const fs::path& file, const char* outcome,
                   const std::string& why) const;
  fs::path cell_file(const Cell& cell) const;

  const RunRequest& request_;
  const Plan& plan_;
  const std::vector<Cell> cells_;
  const fs::path folder_;
  const std::string started_ = utc_now();
  Progress progress_;
  References references_;
  std::vector<Json> rows_;  // of all cells so far
};

fs::path Run::cell_file(const Cell& cell) const {
  return folder_ / "cells" /
         (cell.solver->name + "__" + cell.mesh->entry.name + "__src" + std::to_string(cell.source) +
          ".json");
}

Json Run::context(const std::vector<const PlannedMesh*>& meshes,
                  const std::vector<const Description*>& solvers) const {
  Json json = program_context();
  json["started"] = started_;
  json["corpus"] = request_.suite.corpus;
  json["seed"] = request_.suite.seed;
  json["repetitions"] = request_.suite.repetitions;
  json["command"] = request_.command;
  json["meshes"] = Json::array();
  json["sources"] = Json::object();
  for (const PlannedMesh* mesh : meshes) {
    json["meshes"].push_back(mesh->facts);
    json["sources"][mesh->entry.name] = mesh->sources;
  }
  json["solvers"] = Json::array();
  for (const Description* solver : solvers) json["solvers"].push_back(describe(*solver));
  json["skipped"] = Json::array();
  return json;
}

Json Run::cell_context(const Cell& cell) const {
  Json json = context({cell.mesh}, {cell.solver});
  json["started"] = utc_now();
  json["sources"][cell.mesh->entry.name] = {cell.source};
  return json;
}

// The user's own flags come last: Google Benchmark takes the last of several.
std::vector<std::string> Run::benchmark_flags() const {
  std::vector<std::string> flags{
      "--benchmark_repetitions=" + std::to_string(request_.suite.repetitions),
      "--benchmark_min_time=" + Json(request_.suite.min_time).dump()};
  flags.insert(flags.end(), request_.benchmark_flags.begin(), request_.benchmark_flags.end());
  return flags;
}

void Run::write_error(const Cell& cell, const fs::path& file, const char* outcome,
                      const std::string& why) const {
  write_result_file(
      file, benchmark_context(), cell_context(cell),
      {error_row(cell.solver->name, cell.mesh->entry.name, cell.source, outcome, why)});
}

// Starts the cell's process; makes sure that its file exists afterwards, whatever happens to it.
void Run::start_cell(const Cell& cell, const fs::path& file) {
  const auto unable = cell.mesh->unsupported.find(cell.solver->name);
  if (unable != cell.mesh->unsupported.end()) {
    return write_error(cell, file, outcome::kUnsupported, unable->second);
  }
  try {
    const Reference reference = references_.find(cell);
    CellSpec spec{.solver = cell.solver->name,
                  .mesh = cell.mesh->entry.name,
                  .mesh_file = cell.mesh->entry.file.string(),
                  .source = cell.source,
                  .reference = reference.solver,
                  .reference_file = reference.file.string(),
                  .output = file.string(),
                  .run_folder = folder_.string(),
                  .pictured = is_pictured(cell, request_.pictured),
                  .vectors = request_.suite.vectors,
                  .benchmark_flags = benchmark_flags(),
                  .context = cell_context(cell)};
    const Ended ended =
        run_this_program({"cell", Json(spec).dump()}, [this] { progress_.working("measuring"); });
    if (!ended.succeeded()) {
      write_error(cell, file, ended.crashed ? outcome::kCrashed : outcome::kError,
                  ended.describe());
    } else if (!fs::exists(file)) {
      write_error(cell, file, outcome::kError, "ended without writing a result");
    }
  } catch (const HarnessError& error) {
    write_error(cell, file, outcome::kError, error.what());
  }
}

Json Run::run_cell(const Cell& cell) {
  const fs::path file = cell_file(cell);
  start_cell(cell, file);
  return read_json(file).at("benchmarks");
}

// "ok  12.3 ms", "wrong answer: vertex 7 has ..."
std::string summary(const Json& rows) {
  const std::string outcome = rows.front().at("outcome");
  if (outcome != outcome::kOk) {
    return outcome + ": " + rows.front().at("error_message").get<std::string>();
  }
  std::vector<double> times;
  for (const Json& row : rows) times.push_back(row.at("cpu_time"));
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  char text[40];
  std::snprintf(text, sizeof text, "%s  %.4g ms", outcome.c_str(), *middle);
  return text;
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
  std::vector<const PlannedMesh*> meshes;
  for (const PlannedMesh& mesh : plan_.meshes) meshes.push_back(&mesh);
  Json whole = context(meshes, plan_.solvers);
  for (const SkippedMesh& skipped : plan_.skipped) {
    whole["skipped"].push_back({{"mesh", skipped.name}, {"solver", nullptr}, {"why", skipped.why}});
  }
  write_result_file(folder_ / "run.json", benchmark_context(), whole, rows_);
}

RunResult Run::conclude() const {
  RunResult result = RunResult::ok;
  std::size_t ok = 0;
  for (const Json& row : rows_) {
    const std::string outcome = row.at("outcome");
    if (outcome == outcome::kOk) {
      if (row.at("repetition_index") != 0) continue;
      ++ok;
      if (!row.contains("recordings_error")) continue;
      std::cerr << row.at("name").get<std::string>()
                << ": not recorded: " << row.at("recordings_error").get<std::string>() << '\n';
      result = std::max(result, RunResult::error);
      continue;
    }
    std::cerr << row.at("name").get<std::string>() << ": " << outcome << ": "
              << row.at("error_message").get<std::string>() << '\n';
    if (outcome == outcome::kUnsupported) continue;
    result = std::max(
        result, outcome == outcome::kWrongAnswer ? RunResult::wrong_answer : RunResult::error);
  }
  for (const SkippedMesh& skipped : plan_.skipped) {
    std::cerr << "skipped " << skipped.name << ": " << skipped.why << '\n';
    if (skipped.unreadable) result = std::max(result, RunResult::error);
  }
  std::cerr << ok << " of " << cells_.size() << " cells ok\n";
  std::cout << (folder_ / "run.json").string() << std::endl;
  return result;
}

}  // namespace

RunResult run(const RunRequest& request) {
  check_suite(request.suite);
  check_benchmark_flags(request.benchmark_flags);
  const Plan plan = make_plan(request.suite, request.manifest);
  if (plan.meshes.empty()) {
    std::string why = "nothing to run: no mesh of the suite can be read";
    for (const SkippedMesh& skipped : plan.skipped) why += "; " + skipped.why;
    throw HarnessError(why);
  }
  Run run(request, plan, make_run_folder(request));
  run.measure();
  run.assemble();
  return run.conclude();
}

}  // namespace geodesic::harness
