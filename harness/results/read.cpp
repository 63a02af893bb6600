#include "harness/results/read.h"

#include <algorithm>
#include <map>

#include "harness/cells/row.h"
#include "harness/error.h"
#include "harness/results/atomic_file.h"
#include "harness/results/context.h"
#include "harness/results/counters.h"

namespace geodesic::harness {
namespace {

// Text that is shown within a line.
std::string line_at(const Json& object, const char* key) {
  const std::string text = object.at(key);
  const bool one_line = std::none_of(text.begin(), text.end(),
                                     [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (!one_line) throw HarnessError('"' + std::string(key) + "\" has control characters");
  return text;
}

void check_context(const Json& ours) {
  const Json& version = ours.at("schema_version");
  if (version != kSchemaVersion) {
    throw HarnessError("it has schema version " + excerpt(version.dump()) +
                       ", and this program reads " + std::to_string(kSchemaVersion));
  }
  for (const char* key : kComparedKeys) line_at(ours, key);
  line_at(ours, "corpus");
  for (const Json& mesh : ours.at("meshes")) {
    line_at(mesh, "name");
    line_at(mesh, "sha256");
  }
}

// Whoever computes with the numbers of a cell that is ok does not look at them again.
void check_numbers(const Json& row) {
  if (row.at("cpu_time").get<double>() <= 0) throw HarnessError("a \"cpu_time\" is not above 0");
  const auto check = [&](const std::string& key) {
    if (row.contains(key)) row.at(key).get<double>();
  };
  for (const std::string& key : integer_counters()) check(key);
  check("solver_peak_bytes");
}

CellResult cell_of(const Json& row) {
  return {.name = line_at(row, "run_name"),
          .solver = line_at(row, "solver"),
          .mesh = line_at(row, "mesh"),
          .outcome = line_at(row, "outcome"),
          .message = row.contains("error_message") ? line_at(row, "error_message") : "",
          .rows = {}};
}

std::vector<CellResult> cells_of(const Json& rows) {
  std::vector<CellResult> cells;
  std::map<std::string, std::size_t> index;  // by name; cells stay in the file's order
  for (const Json& row : rows) {
    const auto [place, added] = index.emplace(row.at("run_name"), cells.size());
    if (added) cells.push_back(cell_of(row));
    CellResult& cell = cells[place->second];
    if (cell.ok()) check_numbers(row);
    cell.rows.push_back(row);
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
  const auto refuse = [&](const std::string& why) {
    return HarnessError("'" + file.string() + "' is no result file of geodesic-bench: " + why);
  };
  try {
    ResultFile result{.file = file, .context = json.at("context"), .cells = {}};
    check_context(result.ours());
    result.cells = cells_of(json.at("benchmarks"));
    return result;
  } catch (const Json::exception& error) {
    throw refuse(error.what());
  } catch (const HarnessError& error) {
    throw refuse(error.what());
  }
}

}  // namespace geodesic::harness
