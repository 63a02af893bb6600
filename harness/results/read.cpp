#include "harness/results/read.h"

#include <map>

#include "harness/cells/row.h"
#include "harness/error.h"
#include "harness/results/atomic_file.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace {

CellResult cell_of(const Json& row) {
  return {.name = row.at("run_name"),
          .solver = row.at("solver"),
          .mesh = row.at("mesh"),
          .outcome = row.at("outcome"),
          .message = row.value("error_message", ""),
          .rows = {}};
}

std::vector<CellResult> cells_of(const Json& rows) {
  std::vector<CellResult> cells;
  std::map<std::string, std::size_t> index;  // by name; cells stay in the file's order
  for (const Json& row : rows) {
    const auto [place, added] = index.emplace(row.at("run_name"), cells.size());
    if (added) cells.push_back(cell_of(row));
    cells[place->second].rows.push_back(row);
  }
  return cells;
}

}  // namespace

bool CellResult::ok() const { return outcome == outcome::kOk; }

std::vector<double> CellResult::values(const std::string& key) const {
  std::vector<double> values;
  if (!ok()) return values;
  for (const Json& row : rows) {
    if (row.contains(key)) values.push_back(row.at(key));
  }
  return values;
}

ResultFile read_result_file(const std::filesystem::path& path) {
  const std::filesystem::path file = std::filesystem::is_directory(path) ? path / "run.json" : path;
  return parse_result_file(read_json(file), file);
}

ResultFile parse_result_file(const Json& json, const std::filesystem::path& file) {
  const std::string what = "'" + file.string() + "' is no result file of geodesic-bench";
  try {
    ResultFile result{.file = file, .context = json.at("context"), .cells = {}};
    const int version = result.ours().at("schema_version");
    if (version != kSchemaVersion) {
      throw HarnessError("'" + file.string() + "' has schema version " + std::to_string(version) +
                         ", and this program reads " + std::to_string(kSchemaVersion));
    }
    result.cells = cells_of(json.at("benchmarks"));
    return result;
  } catch (const Json::exception& error) {
    throw HarnessError(what + ": " + error.what());
  }
}

}  // namespace geodesic::harness
