#include "harness/exports/exports.h"

#include <algorithm>
#include <functional>
#include <map>

#include "harness/base/error.h"
#include "harness/compare/statistics.h"
#include "harness/results/counters.h"

namespace geodesic::harness {
namespace {

constexpr const char* kTime = "cpu_time";
constexpr const char* kMemory = "solver_peak_bytes";

// Numbers that are the same in every repetition and of which less is better.
std::vector<std::string> constant_numbers() {
  std::vector<std::string> keys = integer_counters();
  keys.emplace_back(kMemory);
  return keys;
}

const char* unit_of(const std::string& key) {
  if (key == kMemory) return "bytes";
  return key == "strip_depth" ? "faces" : "windows";
}

void for_each_number(const CellResult& cell,
                     const std::function<void(const std::string&, double)>& take) {
  for (const std::string& key : constant_numbers()) {
    const std::vector<double> values = cell.values(key);
    if (!values.empty()) take(key, values.front());
  }
}

struct Times {
  double median, least, most;
};

Times times_of(const CellResult& cell) {
  const std::vector<double> times = cell.values(kTime);
  const auto [least, most] = std::minmax_element(times.begin(), times.end());
  return {median(times), *least, *most};
}

std::string to_github_action_benchmark(const ResultFile& result) {
  Json json = Json::array();
  for (const CellResult& cell : result.cells) {
    if (!cell.ok()) continue;
    const Times times = times_of(cell);
    json.push_back({{"name", cell.name + " " + kTime},
                    {"unit", "ms"},
                    {"value", times.median},
                    {"range", Json(times.least).dump() + " to " + Json(times.most).dump()}});
    for_each_number(cell, [&](const std::string& key, double value) {
      json.push_back({{"name", cell.name + " " + key}, {"unit", unit_of(key)}, {"value", value}});
    });
  }
  return json.dump(2) + '\n';
}

std::string to_bencher(const ResultFile& result) {
  constexpr double kNanoseconds = 1e6;  // in a millisecond
  Json json = Json::object();
  for (const CellResult& cell : result.cells) {
    if (!cell.ok()) continue;
    const Times times = times_of(cell);
    Json& measures = json[cell.name];
    measures["latency"] = {{"value", times.median * kNanoseconds},
                           {"lower_value", times.least * kNanoseconds},
                           {"upper_value", times.most * kNanoseconds}};
    for_each_number(cell, [&](std::string key, double value) {
      std::replace(key.begin(), key.end(), '_', '-');
      measures[key] = {{"value", value}};
    });
  }
  return json.dump(2) + '\n';
}

// The lower of two in the middle: a row must be one that was measured.
std::string to_gbench_median(const ResultFile& result) {
  Json json{{"context", result.context}, {"benchmarks", Json::array()}};
  for (const CellResult& cell : result.cells) {
    std::vector<Json> rows = cell.rows;
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>((rows.size() - 1) / 2);
    std::nth_element(rows.begin(), middle, rows.end(), [](const Json& a, const Json& b) {
      return a.value(kTime, 0.0) < b.value(kTime, 0.0);
    });
    (*middle)["repetitions"] = 1;
    (*middle)["repetition_index"] = 0;
    json["benchmarks"].push_back(std::move(*middle));
  }
  return json.dump(2) + '\n';
}

std::string quoted(const Json& row, const std::string& key) {
  if (!row.contains(key)) return "";
  const Json& value = row.at(key);
  if (!value.is_string()) return value.dump();
  std::string text = "\"";
  for (const char c : harmless(value.get<std::string>()))
    text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

std::string to_csv(const ResultFile& result) {
  std::vector<std::string> keys{
      "name",          "solver",           "mesh",      "source",   "outcome",
      "error_message", "repetition_index", "real_time", "cpu_time", "time_unit",
      "mesh_time",     "prepare_time"};
  for (const std::string& key : counter_names()) keys.push_back(key);
  for (const char* key :
       {kMemory, "process_peak_bytes", "unreachable_vertices", "max_relative_error", "reference"}) {
    keys.emplace_back(key);
  }
  std::string text = join(keys, ",") + '\n';
  for (const CellResult& cell : result.cells) {
    for (const Json& row : cell.rows) {
      std::vector<std::string> values;
      for (const std::string& key : keys) values.push_back(quoted(row, key));
      text += join(values, ",") + '\n';
    }
  }
  return text;
}

using Exporter = std::string (*)(const ResultFile&);

const std::map<std::string, Exporter>& exporters() {
  static const std::map<std::string, Exporter> all{
      {"bencher", to_bencher},
      {"csv", to_csv},
      {"gbench-median", to_gbench_median},
      {"github-action-benchmark", to_github_action_benchmark}};
  return all;
}

}  // namespace

const std::vector<std::string>& export_formats() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> keys;
    for (const auto& [name, exporter] : exporters()) keys.push_back(name);
    return keys;
  }();
  return names;
}

void check_export_format(const std::string& format) {
  if (exporters().contains(format)) return;
  throw HarnessError(unknown_name("export format", format, export_formats()));
}

std::string export_as(const std::string& format, const ResultFile& result) {
  check_export_format(format);
  return exporters().at(format)(result);
}

}  // namespace geodesic::harness
