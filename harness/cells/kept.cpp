#include "harness/cells/kept.h"

#include <iostream>

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// @throws std::exception saying what is wrong with them
Json sound_rows(const Cell& cell, const CellSpec& spec) {
  const Json file = read_json(spec.output);
  if (!is_intact(file)) throw HarnessError("is not as it was written");
  const Json& rows = file.at("benchmarks");
  for (const Json& row : rows) {
    if (row.at("name") != row_name(spec.solver, spec.mesh, spec.source)) {
      throw HarnessError("is of another cell");
    }
    if (row.contains("recordings") &&
        !fs::exists(fs::path(spec.run_folder) / row.at("recordings").get<std::string>())) {
      throw HarnessError("has lost its recordings");
    }
  }
  if (rows.empty()) throw HarnessError("has no row");
  const Json& first = rows.front();
  if (cell.repetition < 0 ? first.at("repetitions") != rows.size()
                          : first.at("repetition_index") != cell.repetition) {
    throw HarnessError("has not all its repetitions");
  }
  if (first.value("program", "") != (cell.program == nullptr ? "" : cell.program->name)) {
    throw HarnessError("is of another program");
  }
  return rows;
}

}  // namespace

void remove_parts_of_files(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == kPartOfFile) fs::remove(entry.path(), ignored);
  }
}

std::optional<Json> kept_rows(const Cell& cell, const CellSpec& spec) {
  if (!fs::exists(spec.output)) return std::nullopt;
  try {
    return sound_rows(cell, spec);
  } catch (const std::exception& error) {
    std::cerr << spec.output << ' ' << error.what() << ": the cell is measured again\n";
    fs::remove(spec.output);
    return std::nullopt;
  }
}

}  // namespace geodesic::harness
