#include "harness/results/row.h"

#include <algorithm>

#include "harness/base/atomic_file.h"
#include "harness/base/sha256.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace {

// Bytes that are no UTF-8 as write_json writes them.
std::string compact(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string row_name(const std::string& solver, const std::string& mesh, Index source) {
  return solver + "/" + mesh + "/src:" + std::to_string(source);
}

Json error_row(const std::string& solver, const std::string& mesh, Index source,
               const char* outcome, std::string why) {
  std::replace(why.begin(), why.end(), '\n', ' ');
  const std::string name = row_name(solver, mesh, source);
  return {
      {"name", name},
      {"family_index", 0},
      {"per_family_instance_index", 0},
      {"run_name", name},
      {"run_type", "iteration"},
      {"repetitions", 1},
      {"repetition_index", 0},
      {"threads", 1},
      {"error_occurred", true},
      {"error_message", why},
      {"iterations", 0},
      {"real_time", 0.0},
      {"cpu_time", 0.0},
      {"time_unit", "ms"},
      {"solver", solver},
      {"mesh", mesh},
      {"source", source},
      {"outcome", outcome},
  };
}

void write_result_file(const std::filesystem::path& file, Json benchmark_context, Json context,
                       const std::vector<Json>& rows, const Json& more) {
  context["finished"] = utc_now();
  benchmark_context["geodesic_bench"] = std::move(context);
  Json json{{"context", std::move(benchmark_context)}, {"benchmarks", rows}};
  json.update(more);
  json["context"]["geodesic_bench"]["checksum"] = sha256_of(compact(json));
  write_json(file, json);
}

bool is_intact(Json result_file) {
  try {
    Json& ours = result_file.at("context").at("geodesic_bench");
    const std::string checksum = ours.at("checksum");
    ours.erase("checksum");
    return checksum == sha256_of(compact(result_file));
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace geodesic::harness
