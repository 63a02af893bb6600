#include "harness/verify/spec.h"

#include <cmath>

namespace geodesic::conformance {
namespace {

using harness::Json;

Json query_json(const Query& query) {
  Json sources = Json::array();
  for (const Source& source : query.sources) sources.push_back({source.vertex, source.distance});
  return {{"sources", sources},
          {"limit", std::isinf(query.limit) ? Json(nullptr) : Json(query.limit)}};
}

Query query_of(const Json& json) {
  Query query;
  for (const Json& source : json.at("sources")) {
    query.sources.push_back({source.at(0).get<Index>(), source.at(1).get<double>()});
  }
  if (!json.at("limit").is_null()) json.at("limit").get_to(query.limit);
  return query;
}

}  // namespace

void to_json(Json& json, const ExaminationSpec& spec) {
  Json queries = Json::array();
  for (const Query& query : spec.queries) queries.push_back(query_json(query));
  json = {{"solver", spec.solver}, {"property", spec.property}, {"mesh_file", spec.mesh_file},
          {"queries", queries},    {"vectors", spec.vectors},   {"explain", spec.explain},
          {"report", spec.report}};
}

void from_json(const Json& json, ExaminationSpec& spec) {
  json.at("solver").get_to(spec.solver);
  json.at("property").get_to(spec.property);
  json.at("mesh_file").get_to(spec.mesh_file);
  for (const Json& query : json.at("queries")) spec.queries.push_back(query_of(query));
  json.at("vectors").get_to(spec.vectors);
  json.at("explain").get_to(spec.explain);
  json.at("report").get_to(spec.report);
}

void to_json(Json& json, const Report& report) {
  json = {{"outcome", report.outcome},
          {"what", report.what},
          {"kind", report.kind},
          {"at_case", report.at_case},
          {"query", query_json(report.query)},
          {"explanation", report.explanation}};
}

void from_json(const Json& json, Report& report) {
  json.at("outcome").get_to(report.outcome);
  json.at("what").get_to(report.what);
  json.at("kind").get_to(report.kind);
  json.at("at_case").get_to(report.at_case);
  report.query = query_of(json.at("query"));
  json.at("explanation").get_to(report.explanation);
}

}  // namespace geodesic::conformance
