#include "harness/results/row.h"

#include <algorithm>

#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/results/context.h"
#include "solvers/core/number_text.h"

namespace geodesic::harness {
namespace {

// Calls visit(key, member) for every member that may be empty, in the order of result files.
template <class SomeRow, class Visit>
void for_each_optional(SomeRow& row, const Visit& visit) {
  visit("program", row.program);
  visit("processor", row.processor);
  visit("stolen_share", row.stolen_share);
  visit("involuntary_switches_per_s", row.involuntary_switches_per_s);
  visit("instruction_set", row.instruction_set);
  visit("timed", row.timed);
  visit("prepare_time", row.prepare_time);
  visit("certificate", row.certificate);
  visit("renew_time", row.renew_time);
  for_each_counter(row.counters, visit);
  visit("phase_seconds", row.phase_seconds);
  visit("paths", row.paths);
  visit("further", row.further);
  visit("further_errors", row.further_errors);
  visit("solver_peak_bytes", row.solver_peak_bytes);
  visit("unreachable_vertices", row.unreachable_vertices);
  visit("recordings", row.recordings);
  visit("recordings_error", row.recordings_error);
  visit("process_peak_bytes", row.process_peak_bytes);
  visit("max_relative_error", row.max_relative_error);
  visit("mean_relative_error", row.mean_relative_error);
  visit("rms_relative_error", row.rms_relative_error);
  visit("p99_relative_error", row.p99_relative_error);
  visit("unreachable_mismatches", row.unreachable_mismatches);
  visit("reference", row.reference);
  visit("mesh_time", row.mesh_time);
}

// Compact JSON. Bytes that are not UTF-8 are replaced, as in write_json.
std::string compact(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string row_name(const std::string& solver, const std::string& mesh,
                     const std::string& source) {
  return solver + "/" + mesh + "/src:" + source;
}

Json source_in_json(const std::string& name) {
  const std::optional<Index> vertex = number_in<Index>(name);
  return vertex ? Json(*vertex) : Json(name);
}

std::string Row::name() const { return row_name(solver, mesh, source); }

void to_json(Json& json, const Row& row) {
  json = {{"name", row.name()},
          {"family_index", row.family_index},
          {"per_family_instance_index", 0},
          {"run_name", row.name()},
          {"run_type", "iteration"},
          {"repetitions", row.repetitions},
          {"repetition_index", row.repetition_index},
          {"threads", row.threads}};
  if (!row.ok()) {
    std::string line = row.error_message;
    std::ranges::replace(line, '\n', ' ');
    json["error_occurred"] = true;
    json["error_message"] = line;
  }
  json.update({{"iterations", row.iterations},
               {"real_time", row.real_time},
               {"cpu_time", row.cpu_time},
               {"time_unit", "ms"},
               {"solver", row.solver},
               {"mesh", row.mesh},
               {"source", source_in_json(row.source)},
               {"outcome", row.outcome}});
  for_each_optional(row, [&](const char* key, const auto& value) {
    if (value) json[key] = *value;
  });
}

void from_json(const Json& json, Row& row) {
  json.at("solver").get_to(row.solver);
  json.at("mesh").get_to(row.mesh);
  const Json& source = json.at("source");
  row.source = source.is_string() ? source.get<std::string>() : source.dump();
  json.at("repetitions").get_to(row.repetitions);
  json.at("repetition_index").get_to(row.repetition_index);
  json.at("threads").get_to(row.threads);
  json.at("outcome").get_to(row.outcome);
  row.error_message = json.value("error_message", "");
  json.at("iterations").get_to(row.iterations);
  json.at("real_time").get_to(row.real_time);
  json.at("cpu_time").get_to(row.cpu_time);
  for_each_optional(row, [&](const char* key, auto& value) {
    if (json.contains(key)) json.at(key).get_to(value.emplace());
  });
}

void write_result_file(const std::filesystem::path& file, Json benchmark_context, Json context,
                       const std::vector<Row>& rows) {
  context["finished"] = utc_now();
  benchmark_context["geodesic_bench"] = std::move(context);
  Json json{{"context", std::move(benchmark_context)}, {"benchmarks", rows}};
  json["context"]["geodesic_bench"]["checksum"] = sha256_of(compact(json));
  write_json(file, json);
}

std::vector<Row> rows_in(const Json& result_file) {
  try {
    std::vector<Row> rows = result_file.at("benchmarks");
    if (rows.empty()) throw HarnessError("has no row");
    return rows;
  } catch (const Json::exception&) {
    throw HarnessError("is not as it was written");
  }
}

std::vector<Row> read_rows(const std::filesystem::path& file) {
  Json json = read_json(file);
  try {
    Json& ours = json.at("context").at("geodesic_bench");
    const std::string checksum = ours.at("checksum");
    ours.erase("checksum");
    if (checksum != sha256_of(compact(json))) throw HarnessError("is not as it was written");
    std::vector<Row> rows = rows_in(json);
    for (Row& row : rows) row.processor = ours.at("processor").get<std::string>();
    return rows;
  } catch (const Json::exception&) {
    throw HarnessError("is not as it was written");
  }
}

}  // namespace geodesic::harness
