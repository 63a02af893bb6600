#include "harness/cells/measure.h"

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/cells/context.h"
#include "harness/cells/ending.h"
#include "harness/measure/benchmark.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

// Makes sure that the cell's file exists afterwards.
void start(const Cell& cell, CellSpec& spec, References& references, const ProcessLimits& limits,
           const std::function<void()>& waiting) {
  const auto unable = cell.mesh->unsupported.find(spec.solver);
  if (unable != cell.mesh->unsupported.end()) {
    return write_failure(spec, outcome::kUnsupported, unable->second);
  }
  try {
    const Reference reference = references.find(cell);
    spec.reference = reference.solver;
    spec.reference_file = reference.file.string();
    const Ended ended = run_this_program({"cell", Json(spec).dump()}, waiting, limits);
    if (!ended.succeeded()) {
      const Failure failure = failure_of(ended, limits);
      write_failure(spec, failure.outcome, failure.why);
    } else if (!std::filesystem::exists(spec.output)) {
      write_failure(spec, outcome::kError, "ended without writing a result");
    }
  } catch (const CannotWrite&) {
    throw;
  } catch (const HarnessError& error) {
    write_failure(spec, outcome::kError, error.what());
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
  const std::string name = spec.solver + "__" + spec.mesh + "__src" + std::to_string(cell.source);
  spec.output = folder / "cells" / (name + ".json");
  spec.run_folder = folder;
  spec.vectors = suite.vectors;
  spec.benchmark_flags = {"--benchmark_repetitions=" + std::to_string(suite.repetitions),
                          "--benchmark_min_time=" + Json(suite.min_time).dump()};
  spec.context = run_context(suite, {cell.mesh}, {cell.solver}, command);
  spec.context["sources"][spec.mesh] = {cell.source};
  return spec;
}

void write_failure(const CellSpec& spec, const char* outcome, const std::string& why) {
  write_result_file(spec.output, benchmark_context(), spec.context,
                    {error_row(spec.solver, spec.mesh, spec.source, outcome, why)});
}

Json measure_cell(const Cell& cell, CellSpec spec, References& references,
                  const ProcessLimits& limits, const std::function<void()>& waiting) {
  start(cell, spec, references, limits, waiting);
  return read_json(spec.output).at("benchmarks");
}

}  // namespace geodesic::harness
