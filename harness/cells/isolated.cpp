#include "harness/cells/isolated.h"

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/measure/benchmark.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Which of several repetitions a row is, and of which program.
void label(Row& row, const Cell& cell) {
  if (cell.repetition >= 0) {
    row.repetitions = cell.repetitions;
    row.repetition_index = cell.repetition;
  }
  if (cell.program != nullptr) row.program = cell.program->name;
}

// Makes the cell's file of what the process wrote and what is known of the process.
std::vector<Row> complete(const Cell& cell, const CellSpec& spec, const fs::path& written,
                          const Disturbance& disturbance) {
  if (!fs::exists(written)) throw HarnessError("ended without writing a result");
  CellFile file = read_cell_file(written);
  fs::remove(written);
  for (Row& row : file.rows) {
    label(row, cell);
    if (row.name() != cell.name()) {
      throw HarnessError("measured " + row.name() + ": this program knows no sets of sources");
    }
    row.stolen_share = disturbance.stolen_share;
    row.involuntary_switches_per_s = disturbance.involuntary_switches_per_s;
  }
  write_result_file(spec.output, std::move(file.benchmark_context), spec.context, file.rows);
  return std::move(file.rows);
}

}  // namespace

ProcessLimits limits_of(const Suite& suite) {
  ProcessLimits limits{.seconds = suite.time_limit};
  if (suite.memory_limit) limits.memory_bytes = *suite.memory_limit;
  return limits;
}

std::vector<Row> write_failure(const Cell& cell, const CellSpec& spec, Outcome outcome,
                               const std::string& why) {
  Row row{.solver = spec.solver,
          .mesh = spec.mesh,
          .source = cell.source->name,
          .outcome = outcome,
          .error_message = why};
  label(row, cell);
  write_result_file(spec.output, benchmark_context(), spec.context, {row});
  return {row};
}

std::vector<Row> measure_cell(const Cell& cell, CellSpec spec, References& references,
                              const ProcessLimits& limits, const std::function<void()>& waiting) {
  if (const std::string* why = cell.unsupported()) {
    return write_failure(cell, spec, Outcome::unsupported, *why);
  }
  try {
    const Reference reference = references.find(cell);
    spec.reference = reference.solver;
    spec.reference_file = reference.file.string();
    CellSpec given = spec;
    given.output += kPartOfFile;
    const fs::path program = cell.program == nullptr ? "/proc/self/exe" : cell.program->file;
    const Ended ended = run_geodesic_bench({"cell", Json(given).dump()}, waiting, limits, program);
    if (ended.succeeded()) return complete(cell, spec, given.output, ended.disturbance);
    const Failure failure = failure_of(ended, limits);
    return write_failure(cell, spec, failure.outcome, failure.why);
  } catch (const CannotWrite&) {
    throw;
  } catch (const HarnessError& error) {
    return write_failure(cell, spec, Outcome::error, error.what());
  }
}

}  // namespace geodesic::harness
