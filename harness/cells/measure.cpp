#include "harness/cells/measure.h"

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/base/plugins.h"
#include "harness/cells/context.h"
#include "harness/cells/ending.h"
#include "harness/measure/benchmark.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

// Which of several repetitions a row is, and by which program.
void label(Json& row, const Cell& cell) {
  if (cell.repetition >= 0) {
    row["repetitions"] = cell.repetitions;
    row["repetition_index"] = cell.repetition;
  }
  if (cell.program != nullptr) row["program"] = cell.program->name;
}

Ended run_cell_program(const Cell& cell, const CellSpec& spec, const ProcessLimits& limits,
                       const std::function<void()>& waiting) {
  std::vector<std::string> words = plugin_arguments();
  words.insert(words.end(), {"cell", Json(spec).dump()});
  const std::filesystem::path program =
      cell.program == nullptr ? "/proc/self/exe" : cell.program->file;
  return run_program(program, words, waiting, limits);
}

// What the process wrote becomes the cell's file, with what is known of the process.
void complete(const Cell& cell, const CellSpec& spec, const std::filesystem::path& written,
              const Disturbance& disturbance) {
  if (!std::filesystem::exists(written)) throw HarnessError("ended without writing a result");
  Json file = read_json(written);
  std::filesystem::remove(written);
  if (!is_intact(file)) throw HarnessError("wrote a result that is damaged");
  std::vector<Json> rows = file.at("benchmarks");
  for (Json& row : rows) {
    label(row, cell);
    row["stolen_share"] = disturbance.stolen_share;
    row["involuntary_switches_per_s"] = disturbance.involuntary_switches_per_s;
  }
  Json benchmark = std::move(file["context"]);
  benchmark.erase("geodesic_bench");
  write_result_file(spec.output, std::move(benchmark), spec.context, rows);
}

// Makes sure that the cell's file exists afterwards.
void start(const Cell& cell, CellSpec& spec, References& references, const ProcessLimits& limits,
           const std::function<void()>& waiting) {
  const auto fail = [&](const char* outcome, const std::string& why) {
    write_failure(cell, spec, outcome, why);
  };
  const auto unable = cell.mesh->unsupported.find(spec.solver);
  if (unable != cell.mesh->unsupported.end()) {
    return fail(outcome::kUnsupported, unable->second);
  }
  try {
    const Reference reference = references.find(cell);
    spec.reference = reference.solver;
    spec.reference_file = reference.file.string();
    CellSpec told = spec;
    told.output += kPartOfFile;
    const Ended ended = run_cell_program(cell, told, limits, waiting);
    if (ended.succeeded()) return complete(cell, spec, told.output, ended.disturbance);
    const Failure failure = failure_of(ended, limits);
    fail(failure.outcome, failure.why);
  } catch (const CannotWrite&) {
    throw;
  } catch (const HarnessError& error) {
    fail(outcome::kError, error.what());
  }
}

}  // namespace

CellSpec cell_spec(const Suite& suite, const Cell& cell, const std::filesystem::path& folder,
                   const std::string& command) {
  CellSpec spec;
  spec.solver = cell.solver->name;
  spec.mesh = cell.mesh->entry.name;
  spec.mesh_file = cell.mesh->entry.file.string();
  spec.source = cell.source;
  std::string name = spec.solver + "__" + spec.mesh + "__src" + std::to_string(cell.source);
  int repetitions = suite.repetitions;
  if (cell.repetition >= 0) {
    name += "__rep" + std::to_string(cell.repetition);
    repetitions = 1;
  }
  if (cell.program != nullptr) name += "__" + cell.program->name;
  spec.output = folder / "cells" / (name + ".json");
  spec.run_folder = folder;
  spec.vectors = suite.vectors;
  spec.benchmark_flags = {"--benchmark_repetitions=" + std::to_string(repetitions),
                          "--benchmark_min_time=" + Json(suite.min_time).dump()};
  spec.context = run_context(suite, {cell.mesh}, {cell.solver}, command);
  spec.context["sources"][spec.mesh] = {cell.source};
  spec.counted = cell.is_first();
  if (cell.repetition >= 0) spec.context["interleaved"] = true;
  if (cell.program != nullptr) spec.context["programs"] = {cell.program->facts};
  return spec;
}

void write_failure(const Cell& cell, const CellSpec& spec, const char* outcome,
                   const std::string& why) {
  Json row = error_row(spec.solver, spec.mesh, spec.source, outcome, why);
  label(row, cell);
  write_result_file(spec.output, benchmark_context(), spec.context, {row});
}

Json measure_cell(const Cell& cell, CellSpec spec, References& references,
                  const ProcessLimits& limits, const std::function<void()>& waiting) {
  start(cell, spec, references, limits, waiting);
  return read_json(spec.output).at("benchmarks");
}

}  // namespace geodesic::harness
