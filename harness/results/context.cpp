#include "harness/results/context.h"

#include <ctime>

#include "harness/base/build_info.h"
#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/corpus/solvers.h"
#include "harness/results/environment.h"
#include "meshes/summary.h"

namespace geodesic::harness {

namespace {

Json number_or_text(const ParameterDescription& parameter, const std::string& text) {
  return parameter.is_number() ? Json::parse(text) : Json(text);
}

Json describe(const ParameterDescription& parameter) {
  Json json{{"name", parameter.name},
            {"description", parameter.description},
            {"kind", parameter.kind == ParameterKind::integer ? "integer"
                     : parameter.is_number()                  ? "real"
                                                              : "choice"},
            {"default", number_or_text(parameter, parameter.default_value.text())}};
  if (parameter.is_number()) {
    json["least"] = number_or_text(parameter, ParameterValue(parameter.least).text());
    json["greatest"] = number_or_text(parameter, ParameterValue(parameter.greatest).text());
  } else {
    json["choices"] = parameter.choices;
  }
  return json;
}

}  // namespace

Json describe(const Description& solver) {
  const Abilities& can = solver.abilities;
  Json parameters = Json::array(), values = Json::object();
  for (const ParameterDescription& parameter : solver.parameters) {
    parameters.push_back(describe(parameter));
    values[parameter.name] = number_or_text(parameter, solver.text(parameter.name));
  }
  return {
      {"name", solver.name},
      {"family", solver.family},
      {"paper", solver.paper},
      {"exactness", exactness_name(solver.exactness)},
      {"error_bound",
       solver.exactness == Exactness::bounded ? Json(solver.error_bound(solver)) : Json(nullptr)},
      {"deterministic", solver.deterministic},
      {"threads", solver.thread_count()},
      {"needs_renewal", solver.needs_renewal},
      {"parameters", std::move(parameters)},
      {"values", std::move(values)},
      {"independent_oracle", solver.independent_oracle},
      {"by_name_only", solver.by_name_only},
      {"abilities",
       {{"multiple_sources", can.multiple_sources},
        {"initial_distances", can.initial_distances},
        {"distance_limit", can.distance_limit},
        {"non_manifold_vertices", can.non_manifold_vertices},
        {"degenerate_faces", can.degenerate_faces},
        {"concurrent_objects", can.concurrent_objects},
        {"max_vertices", can.max_vertices == kNone ? Json(nullptr) : Json(can.max_vertices)}}},
      {"remarks", solver.remarks},
  };
}

Json describe(const MeshEntry& entry, const TriangleSoup& soup, const Mesh& mesh) {
  const MeshSummary summary = summarize(soup);
  Json facts{
      {"name", entry.name},
      {"file", entry.file.filename().string()},
      {"sha256", sha256_of_file(entry.file)},
      {"vertices", mesh.vertex_count()},
      {"faces", mesh.face_count()},
      {"edges", summary.edges},
      {"components", summary.components},
      {"boundary_loops", summary.boundary_loops},
      {"genus", summary.genus},
      {"mean_edge_length", mesh.mean_edge_length()},
      {"thesis_model", entry.thesis_model},
      {"stand_in", entry.stand_in},
  };
  if (!entry.why.empty()) facts["why"] = entry.why;
  if (!entry.reports.empty()) facts["reports"] = entry.reports;
  return facts;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc;
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

Json program_context() {
  const BuildInfo& build = build_info();
  Json plugins = Json::array();
  for (const Plugin& plugin : loaded_plugins()) {
    plugins.push_back({{plugin.option == kPluginOption ? "file" : "external", plugin.value},
                       {"sha256", plugin.sha256},
                       {"solvers", plugin.solvers}});
  }
  return {
      {"schema_version", kSchemaVersion},
      {"revision", build.revision},
      {"modified", build.modified},
      {"compiler", build.compiler},
      {"compiler_flags", build.compiler_flags},
      {"build_type", build.build_type},
      {"processor", processor()},
      {"plugins", std::move(plugins)},
  };
}

}  // namespace geodesic::harness
