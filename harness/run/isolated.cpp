#include "harness/run/isolated.h"

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/verify/references.h"

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

class CellProcess {
 public:
  CellProcess(const Cell& cell, CellSpec spec, const ProcessLimits& limits,
              const std::function<void()>& waiting)
      : cell_(cell), spec_(std::move(spec)), limits_(limits), waiting_(waiting) {
    spec_.output += kPartOfFile;
  }

  std::vector<Row> measure(const Reference& reference) {
    spec_.reference = reference.solver;
    spec_.reference_file = reference.file.string();
    const fs::path program = cell_.program == nullptr ? "/proc/self/exe" : cell_.program->file;
    const Ended ended =
        run_geodesic_bench({"cell", Json(spec_).dump()}, waiting_, limits_, program);
    if (!ended.succeeded()) return {failed_row(cell_, failure_of(ended, limits_))};
    std::vector<Row> rows = written_rows();
    for (Row& row : rows) {
      label(row, cell_);
      if (row.name() != cell_.name()) {
        throw HarnessError("measured " + row.name() + ": this program knows no sets of sources");
      }
      row.stolen_share = ended.disturbance.stolen_share;
      row.involuntary_switches_per_s = ended.disturbance.involuntary_switches_per_s;
    }
    return rows;
  }

 private:
  std::vector<Row> written_rows() const {
    if (!fs::exists(spec_.output)) throw HarnessError("ended without writing a result");
    const Json result = read_json(spec_.output);
    fs::remove(spec_.output);
    return rows_in(result);
  }

  const Cell& cell_;
  CellSpec spec_;
  const ProcessLimits& limits_;
  const std::function<void()>& waiting_;
};

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

std::vector<Row> measure_cell(const Cell& cell, CellSpec spec, References& references,
                              const ProcessLimits& limits, const std::function<void()>& waiting) {
  if (const std::string* why = cell.unsupported()) {
    return {failed_row(cell, {Outcome::unsupported, *why})};
  }
  try {
    CellProcess process(cell, std::move(spec), limits, waiting);
    const Reference reference = references.find(cell);
    std::vector<Row> rows = process.measure(reference);
    const bool wrong = rows.front().outcome == Outcome::wrong_answer;
    if (wrong && is_independent_oracle(reference.solver)) {
      if (const auto other = references.find_other_than(reference, cell)) {
        return process.measure(*other);
      }
    }
    return rows;
  } catch (const CannotWrite&) {
    throw;
  } catch (const HarnessError& error) {
    return {failed_row(cell, {Outcome::error, error.what()})};
  }
}

}  // namespace geodesic::harness
