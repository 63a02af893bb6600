#include "harness/cells/context.h"

#include "harness/results/context.h"

namespace geodesic::harness {

Json run_context(const Suite& suite, const std::vector<const PlannedMesh*>& meshes,
                 const std::vector<const Description*>& solvers, const std::string& command) {
  Json json = program_context();
  json["started"] = utc_now();
  json["corpus"] = suite.corpus;
  json["seed"] = suite.seed;
  json["repetitions"] = suite.repetitions;
  json["time_limit"] = suite.time_limit;
  if (suite.memory_limit) json["memory_limit"] = *suite.memory_limit;
  json["expected"] = suite.expected;
  json["command"] = command;
  json["meshes"] = Json::array();
  json["sources"] = Json::object();
  for (const PlannedMesh* mesh : meshes) {
    json["meshes"].push_back(mesh->facts);
    json["sources"][mesh->entry.name] = mesh->sources;
  }
  json["solvers"] = Json::array();
  for (const Description* solver : solvers) json["solvers"].push_back(describe(*solver));
  json["skipped"] = Json::array();
  return json;
}

Json run_context(const Suite& suite, const Plan& plan, const std::string& command) {
  std::vector<const PlannedMesh*> meshes;
  for (const PlannedMesh& mesh : plan.meshes) meshes.push_back(&mesh);
  Json json = run_context(suite, meshes, plan.solvers, command);
  for (const SkippedMesh& skipped : plan.skipped) {
    json["skipped"].push_back({{"mesh", skipped.name}, {"solver", nullptr}, {"why", skipped.why}});
  }
  return json;
}

}  // namespace geodesic::harness
