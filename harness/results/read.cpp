#include "harness/results/read.h"

#include <map>

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/results/context.h"
#include "harness/results/counters.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

// Text that is shown within a line.
std::string text_at(const Json& object, const char* key) {
  const std::string text = object.at(key);
  if (text != harmless(text)) {
    throw HarnessError('"' + std::string(key) + "\" has control characters");
  }
  return text;
}

void check_context(const Json& ours) {
  const Json& version = ours.at("schema_version");
  if (version != kSchemaVersion) {
    throw HarnessError("it has schema version " + excerpt(version.dump()) +
                       ", and this program reads " + std::to_string(kSchemaVersion) +
                       ": run it again");
  }
  for (const char* key : kComparedKeys) text_at(ours, key);
  text_at(ours, "corpus");
  for (const Json& mesh : ours.at("meshes")) {
    text_at(mesh, "name");
    text_at(mesh, "sha256");
  }
}

// Whoever computes with the numbers does not look at them again.
void check_numbers(const Json& row, bool ok) {
  std::vector<std::string> keys = integer_counters();
  keys.insert(keys.end(), {"cpu_time", "solver_peak_bytes"});
  for (const std::string& key : keys) {
    if (row.contains(key) && !row.at(key).is_number()) {
      throw HarnessError(key + " is no number but " + row.at(key).type_name());
    }
  }
  if (ok && row.at("cpu_time") <= 0) throw HarnessError("the cpu_time is not above 0");
}

CellResult cell_of(const Json& row) {
  return {.name = text_at(row, "run_name"),
          .solver = text_at(row, "solver"),
          .mesh = text_at(row, "mesh"),
          .outcome = text_at(row, "outcome"),
          .message = row.contains("error_message") ? text_at(row, "error_message") : "",
          .rows = {}};
}

std::vector<CellResult> cells_of(const Json& rows) {
  if (!rows.is_array() || rows.empty()) throw HarnessError("benchmarks: no list of rows");
  std::vector<CellResult> cells;
  std::map<std::string, std::size_t> index;  // by name; cells stay in the file's order
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string where = "benchmarks[" + std::to_string(i) + "]: ";
    try {
      const auto [place, added] = index.emplace(rows[i].at("run_name"), cells.size());
      if (added) cells.push_back(cell_of(rows[i]));
      CellResult& cell = cells[place->second];
      check_numbers(rows[i], cell.ok());
      cell.rows.push_back(rows[i]);
    } catch (const Json::exception& error) {
      throw HarnessError(where + reason_of(error));
    } catch (const HarnessError& error) {
      throw HarnessError(where + error.what());
    }
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
  return parse_result_file(read_json(file, "a run folder, or a result file in one"), file);
}

ResultFile parse_result_file(const Json& json, const std::filesystem::path& file) {
  const auto refused = [&](const std::string& why) {
    return HarnessError("'" + file.string() + "' is no result file of geodesic-bench: " + why);
  };
  try {
    ResultFile result{.file = file, .context = json.at("context"), .cells = {}};
    check_context(result.ours());
    result.cells = cells_of(json.at("benchmarks"));
    return result;
  } catch (const Json::exception& error) {
    throw refused(reason_of(error));
  } catch (const HarnessError& error) {
    throw refused(error.what());
  }
}

}  // namespace geodesic::harness
