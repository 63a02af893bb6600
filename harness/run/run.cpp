#include "harness/run/run.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "harness/base/control_groups.h"
#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/interruption.h"
#include "harness/base/plugins.h"
#include "harness/corpus/manifest.h"
#include "harness/measure/benchmark.h"
#include "harness/results/context.h"
#include "harness/results/environment.h"
#include "harness/run/folder.h"
#include "harness/run/isolated.h"
#include "harness/run/programs.h"
#include "harness/run/progress.h"
#include "harness/run/reference_files.h"
#include "harness/run/resume.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

class Run {
 public:
  Run(const RunRequest& request, const Plan& plan, fs::path folder)
      : request_(request),
        plan_(plan),
        cells_(plan.interleaved_cells(request_.interleave ? request_.suite.repetitions : -1)),
        folder_(std::move(folder)),
        references_(
            folder_ / "references", request_,
            [this](const std::string& solver) { progress_.working("reference by " + solver); }),
        progress_(cells_, request_.suite) {}

  /// Takes over the cells that an earlier process measured.
  void keep_measured_cells();
  void measure();
  /// Writes run.json.
  void assemble() const;
  RunResult conclude() const;
  /// Prints the number of saved cells and the command that measures the others.
  void explain_resuming() const;

 private:
  CellSpec spec_of(const Cell& cell) const;
  Json context_of(const Cell& cell) const;
  void compute_references(std::size_t first);
  std::vector<Row> rows_of(std::size_t cell);
  std::vector<Row> measure(const Cell& cell, const CellSpec& spec);
  void drop_parts_of_other_processors();
  void note_failure(const Cell& cell, const Row& row);

  const RunRequest& request_;
  const Plan& plan_;
  const std::vector<Cell> cells_;
  const fs::path folder_;
  const std::string processor_ = processor();
  ReferenceFiles references_;
  CellLines progress_;
  std::map<std::size_t, std::vector<Row>> kept_;  // by cell
  std::size_t measured_ = 0, ok_ = 0;             // cells
  std::size_t referenced_ = 0;  // the references of the cells before this one have been computed
  std::vector<Row> rows_;       // of all cells so far
  // The outcome and source of the first cell that exceeded its memory or time limit.
  std::map<std::tuple<const Program*, const Description*, const PlannedMesh*>, std::string>
      exhausted_;
  std::set<std::pair<const Program*, std::string>> failed_;  // names of cells
};

CellSpec Run::spec_of(const Cell& cell) const {
  const Suite& suite = request_.suite;
  const bool alone = cell.repetition >= 0;
  const bool first_program = cell.program == nullptr || cell.program == &plan_.programs.front();
  CellSpec spec{.solver = cell.solver->name,
                .mesh = cell.mesh->entry.name,
                .mesh_file = cell.mesh->entry.file.string(),
                .source = cell.source->vertices.front(),
                .run_folder = folder_,
                .with_counters = cell.is_first_repetition(),
                .with_recordings = first_program && leaves_recordings(cell, request_.recordings),
                .frames = request_.frames,
                .other_queries = suite.other_queries,
                .path_targets = suite.path_targets,
                .vectors = suite.vectors,
                .repair = request_.repair};
  std::string name = spec.solver + "__" + spec.mesh + "__src" + cell.source->name;
  if (alone) name += "__rep" + std::to_string(cell.repetition);
  if (cell.program != nullptr) name += "__" + cell.program->name;
  spec.output = folder_ / "cells" / (as_file_name(name) + ".json");
  if (!cell.source->is_single()) {
    spec.source_set = cell.source->name;
    spec.sources_file = folder_ / source_file(*cell.mesh, *cell.source);
  }
  if (has_further_sources(cell)) {
    spec.further_sources = folder_ / further_sources_file(*cell.mesh);
  }
  spec.benchmark_flags = {
      "--benchmark_repetitions=" + std::to_string(alone ? 1 : suite.repetitions),
      "--benchmark_min_time=" + Json(suite.min_time).dump()};
  // Google Benchmark uses the last of repeated flags.
  spec.benchmark_flags.insert(spec.benchmark_flags.end(), request_.benchmark_flags.begin(),
                              request_.benchmark_flags.end());
  return spec;
}

Json Run::context_of(const Cell& cell) const {
  Json context = run_context(request_, plan_, cell.mesh, cell.solver);
  const std::string& mesh = cell.mesh->entry.name;
  if (cell.program != nullptr) context["programs"] = {cell.program->facts};
  context["sources"][mesh] = names_in_json({*cell.source});
  context.erase("source_sets");
  if (!cell.source->is_single()) {
    context["source_sets"][mesh][cell.source->name] = describe(*cell.mesh, *cell.source);
  }
  return context;
}

void Run::keep_measured_cells() {
  remove_parts_of_files(folder_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (auto rows = kept_rows(cells_[i], spec_of(cells_[i]))) kept_[i] = std::move(*rows);
  }
  drop_parts_of_other_processors();
  std::cerr << kept_.size() << " of " << cells_.size() << " cells are kept from "
            << folder_.string() << '\n';
}

// All solvers of a mesh and source are measured on one processor, so that their times can be
// compared. If another processor measured only some of them, all are measured again.
void Run::drop_parts_of_other_processors() {
  const auto is_of_another = [&](std::size_t cell) {
    const auto kept = kept_.find(cell);
    return kept != kept_.end() && kept->second.front().processor != processor_;
  };
  for (std::size_t first = 0, last = 0; first < cells_.size(); first = last) {
    bool complete = true, ours = true;
    for (; last < cells_.size() && cells_[last].mesh == cells_[first].mesh &&
           cells_[last].source == cells_[first].source;
         ++last) {
      complete = complete && kept_.contains(last);
      ours = ours && !is_of_another(last);
    }
    if (complete || ours) continue;
    for (std::size_t i = first; i < last; ++i) {
      if (kept_.erase(i) > 0) fs::remove(spec_of(cells_[i]).output);
    }
    std::cerr << cells_[first].mesh->entry.name << ", source " << cells_[first].source->name
              << ": was begun on another processor and is measured again\n";
  }
}

std::vector<Row> Run::measure(const Cell& cell, const CellSpec& spec) {
  const auto exhausted = exhausted_.find({cell.program, cell.solver, cell.mesh});
  if (exhausted != exhausted_.end()) {
    return {failed_row(cell, {Outcome::skipped, exhausted->second})};
  }
  return measure_cell(cell, spec, references_, limits_of(request_.suite),
                      [this] { progress_.working("measuring"); });
}

// Other repetitions would fail as well, and other sources of the mesh would exceed the same limit.
void Run::note_failure(const Cell& cell, const Row& row) {
  if (row.ok()) {
    ++ok_;
    return;
  }
  failed_.insert({cell.program, cell.name()});
  if (row.outcome == Outcome::out_of_memory || row.outcome == Outcome::time_out) {
    exhausted_.try_emplace({cell.program, cell.solver, cell.mesh},
                           std::string(name_of(row.outcome)) + " from source " + cell.source->name);
  }
}

// Computes the references of this cell's source and of the next sources of its mesh, one source a
// thread. With one thread, each is computed when it is needed.
void Run::compute_references(std::size_t first) {
  if (request_.threads == 1 || first < referenced_) return;
  std::set<const SourceSet*> sources;
  std::vector<const Cell*> ahead;
  for (referenced_ = first; referenced_ < cells_.size(); ++referenced_) {
    const Cell& cell = cells_[referenced_];
    if (cell.mesh != cells_[first].mesh) break;
    sources.insert(cell.source);
    if (sources.size() > request_.threads) break;
    if (!kept_.contains(referenced_)) ahead.push_back(&cell);
  }
  references_.compute_ahead(ahead);
}

std::vector<Row> Run::rows_of(std::size_t cell) {
  const auto kept = kept_.find(cell);
  if (kept != kept_.end()) {
    progress_.leave_out();
    return kept->second;
  }
  compute_references(cell);
  const CellSpec spec = spec_of(cells_[cell]);
  std::vector<Row> rows = measure(cells_[cell], spec);
  write_result_file(spec.output, benchmark_context(), context_of(cells_[cell]), rows);
  for (Row& row : rows) row.processor = processor_;
  ++measured_;
  progress_.ended(one_line(rows));
  return rows;
}

void Run::measure() {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    throw_if_interrupted();
    if (failed_.contains({cells_[i].program, cells_[i].name()})) {
      progress_.leave_out();
      continue;
    }
    std::vector<Row> rows = rows_of(i);
    note_failure(cells_[i], rows.front());
    for (Row& row : rows) {
      row.family_index = static_cast<int>(i);  // 0 in the cell's own file
      rows_.push_back(std::move(row));
    }
  }
}

void Run::explain_resuming() const {
  const std::string folder = fs::absolute(folder_).string();
  std::cerr << "\n"
            << kept_.size() + measured_ << " of " << cells_.size() << " cells are saved in "
            << folder;
  if (!request_.of_script) {
    std::cerr << "; to measure the others:\n  " << as_command_line({"run", "--resume", folder});
  }
  std::cerr << std::endl;
}

void Run::assemble() const {
  Json whole = run_context(request_, plan_);
  whole["started"] = request_.started;
  std::vector<Row> rows = rows_;
  if (!rows.empty()) whole["processor"] = *rows_.front().processor;
  for (Row& row : rows) {
    if (row.processor == rows_.front().processor) row.processor.reset();
  }
  if (request_.shard) whole["shard"] = shard_context(request_, plan_);
  for (const Program& program : plan_.programs) whole["programs"].push_back(program.facts);
  if (!request_.changes.empty()) whole["changes"] = request_.changes;
  write_result_file(folder_ / "run.json", benchmark_context(), whole, rows);
}

RunResult Run::conclude() const {
  const RunResult result = report_failures(rows_, plan_, request_.suite);
  const auto unsupported = std::ranges::count(rows_, Outcome::unsupported, &Row::outcome);
  std::cerr << ok_ << " of " << cells_.size() << " cells ok";
  if (unsupported > 0) std::cerr << ", " << unsupported << " unsupported as declared";
  if (const std::size_t skipped = plan_.skipped.size(); skipped > 0) {
    std::cerr << "; " << plan_.meshes.size() << " of " << plan_.meshes.size() + skipped
              << " meshes, " << skipped << " skipped";
  }
  std::cerr << std::endl;
  std::cout << (folder_ / "run.json").string() << std::endl;
  return result;
}

// Warns of files with the name of another mesh in the manifest: results identify meshes by name.
void warn_of_names(const Plan& plan, const fs::path& manifest) {
  const auto is_file = [](const PlannedMesh& mesh) { return mesh.entry.kind == "file"; };
  if (std::ranges::none_of(plan.meshes, is_file) || !fs::exists(manifest)) return;
  const Manifest named(manifest, dataset_cache());
  for (const Json& known : named.json().at("meshes")) {
    for (const PlannedMesh& mesh : plan.meshes) {
      if (known.at("name") == mesh.entry.name && known.at("sha256") != mesh.facts.at("sha256")) {
        std::cerr << "warning: " << mesh.entry.file.string() << " is not the mesh '"
                  << mesh.entry.name << "' of " << manifest.string()
                  << ": rename it if the results are to stand beside those of others\n";
      }
    }
  }
}

void write_sources(const Plan& plan, const fs::path& folder) {
  const auto write = [&](const fs::path& file, const std::vector<Index>& vertices) {
    make_folder((folder / file).parent_path());
    write_source_vertices(folder / file, vertices);
  };
  for (const PlannedMesh& mesh : plan.meshes) {
    for (const SourceSet& source : mesh.sources) {
      if (!source.is_single()) write(source_file(mesh, source), source.vertices);
    }
    if (!mesh.further_sources.empty()) write(further_sources_file(mesh), mesh.further_sources);
  }
}

// Name of the run folder, after the time. Shards may start in the same second.
std::string default_name(const RunRequest& request) {
  const std::string& corpus = request.suite.corpus;
  if (!request.shard) return corpus;
  return corpus + "-shard-" + std::to_string(request.shard->index) + "-of-" +
         std::to_string(request.shard->of);
}

}  // namespace

RunResult run(RunRequest request) {
  check_suite(request.suite);
  check_benchmark_flags(request.benchmark_flags);
  check_programs(request.programs);
  if (!request.programs.empty()) request.interleave = true;
  if (!request.suite.memory_limit) {
    request.suite.memory_limit = available_memory();
  }
  Plan plan = make_plan(request);
  warn_of_names(plan, request.manifest);
  report_skipped(plan);
  const auto folder = request.resume
                          ? std::make_unique<RunFolder>(*request.resume)
                          : std::make_unique<RunFolder>(request.out, default_name(request));
  identify(request, plan);
  save_request(request, folder->path());
  folder->make_subfolders();
  write_sources(plan, folder->path());

  const InterruptionGuard guard;
  plan.programs = with_facts(request.programs, folder->path());
  Run run(request, plan, folder->path());
  if (request.resume) run.keep_measured_cells();
  try {
    run.measure();
    run.assemble();
  } catch (const std::exception&) {
    run.explain_resuming();
    throw;
  }
  return run.conclude();
}

}  // namespace geodesic::harness
