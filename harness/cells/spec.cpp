#include "harness/cells/spec.h"

namespace geodesic::harness {

void to_json(Json& json, const CellSpec& spec) {
  json = {{"solver", spec.solver},       {"mesh", spec.mesh},
          {"mesh_file", spec.mesh_file}, {"source", spec.source},
          {"reference", spec.reference}, {"reference_file", spec.reference_file},
          {"output", spec.output},       {"run_folder", spec.run_folder},
          {"counted", spec.counted},     {"pictured", spec.pictured},
          {"vectors", spec.vectors},     {"benchmark_flags", spec.benchmark_flags},
          {"context", spec.context}};
}

void from_json(const Json& json, CellSpec& spec) {
  json.at("solver").get_to(spec.solver);
  json.at("mesh").get_to(spec.mesh);
  json.at("mesh_file").get_to(spec.mesh_file);
  json.at("source").get_to(spec.source);
  json.at("reference").get_to(spec.reference);
  json.at("reference_file").get_to(spec.reference_file);
  json.at("output").get_to(spec.output);
  json.at("run_folder").get_to(spec.run_folder);
  json.at("counted").get_to(spec.counted);
  json.at("pictured").get_to(spec.pictured);
  json.at("vectors").get_to(spec.vectors);
  json.at("benchmark_flags").get_to(spec.benchmark_flags);
  spec.context = json.at("context");
}

void to_json(Json& json, const ReferenceSpec& spec) {
  json = {{"solver", spec.solver},
          {"mesh_file", spec.mesh_file},
          {"source", spec.source},
          {"output", spec.output}};
}

void from_json(const Json& json, ReferenceSpec& spec) {
  json.at("solver").get_to(spec.solver);
  json.at("mesh_file").get_to(spec.mesh_file);
  json.at("source").get_to(spec.source);
  json.at("output").get_to(spec.output);
}

}  // namespace geodesic::harness
