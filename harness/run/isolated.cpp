#include "harness/run/isolated.h"

#include "harness/base/error.h"
#include "harness/base/files.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Sets the repetition and the program of a row.
void label(Row& row, const Cell& cell) {
  if (cell.repetition >= 0) {
    row.repetitions = cell.repetitions;
    row.repetition_index = cell.repetition;
  }
  if (cell.program != nullptr) row.program = cell.program->name;
}

std::vector<Row> rows_of_process(const Cell& cell, CellSpec spec, ReferenceFiles& references,
                                 const ProcessLimits& limits,
                                 const std::function<void()>& waiting) {
  spec.output += kPartOfFile;
  const auto [solver, file] = references.find(cell);
  spec.reference = solver;
  spec.reference_file = file.string();
  if (!spec.further_sources.empty() && cell.solver->exactness != Exactness::exact) {
    const auto [by, rows] = references.find_further(cell);
    spec.further_reference = by;
    spec.further_reference_file = rows.string();
  }
  const fs::path program = cell.program == nullptr ? "/proc/self/exe" : cell.program->file;
  const Ended ended = run_geodesic_bench({"cell", Json(spec).dump()}, waiting, limits, program);
  if (!ended.succeeded()) return {failed_row(cell, failure_of(ended, limits))};
  if (!fs::exists(spec.output)) throw HarnessError("ended without writing a result");
  std::vector<Row> rows = rows_in(read_json(spec.output));
  fs::remove(spec.output);
  for (Row& row : rows) {
    label(row, cell);
    if (row.name() != cell.name()) {
      throw HarnessError("measured " + row.name() + ": this program knows no sets of sources");
    }
    row.stolen_share = ended.disturbance.stolen_share;
    row.involuntary_switches_per_s = ended.disturbance.involuntary_switches_per_s;
  }
  return rows;
}

}  // namespace

ProcessLimits limits_of(const Suite& suite) {
  ProcessLimits limits{.seconds = suite.time_limit};
  if (suite.memory_limit) limits.memory_bytes = *suite.memory_limit;
  return limits;
}

Row failed_row(const Cell& cell, const Failure& failure) {
  Row row{.solver = cell.solver->name,
          .mesh = cell.mesh->entry.name,
          .source = cell.source->name,
          .outcome = failure.outcome,
          .error_message = failure.why};
  label(row, cell);
  return row;
}

std::vector<Row> measure_cell(const Cell& cell, const CellSpec& spec, ReferenceFiles& references,
                              const ProcessLimits& limits, const std::function<void()>& waiting) {
  if (const std::string* why = cell.unsupported()) {
    return {failed_row(cell, {Outcome::unsupported, *why})};
  }
  try {
    return rows_of_process(cell, spec, references, limits, waiting);
  } catch (const CannotWrite&) {
    throw;
  } catch (const HarnessError& error) {
    return {failed_row(cell, {Outcome::error, error.what()})};
  }
}

}  // namespace geodesic::harness
