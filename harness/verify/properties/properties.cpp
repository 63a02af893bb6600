#include "harness/verify/properties/properties.h"

#include <algorithm>

#include "harness/base/error.h"

namespace geodesic::harness {

const std::vector<Property>& all_properties() {
  static const std::vector<Property> all = [] {
    std::vector<Property> properties;
    // The most basic ones first, since the first ones that fail are explained.
    for (const auto& group :
         {closed_form_properties(), rough_mesh_properties(), invariance_properties(),
          component_properties(), query_properties(), repetition_properties(),
          recording_properties(), unclean_mesh_properties(), extreme_mesh_properties(),
          path_properties(), sheet_properties()}) {
      properties.insert(properties.end(), group.begin(), group.end());
    }
    return properties;
  }();
  return all;
}

const Property& property_named(std::string_view name) {
  return named("property", all_properties(), name, &Property::name);
}

Cases one(const std::string& name, const TriangleSoup& soup, const Query& query) {
  return {{name, soup, {query}}};
}

Cases random_mesh_cases(const std::vector<Query>& queries) {
  Cases cases;
  for (const auto& [name, soup] : random_meshes()) cases.push_back({name, soup, queries});
  return cases;
}

std::vector<Query> some_sources(const TriangleSoup& soup) {
  const Index count = static_cast<Index>(soup.positions.size());
  return {from(0), from(count / 2), from(count - 1)};
}

Cases random_meshes_from_some_sources() {
  Cases cases = random_mesh_cases({});
  for (Case& each : cases) each.queries = some_sources(each.soup);
  return cases;
}

Cases random_meshes_from_four_sources() {
  Cases cases = random_mesh_cases({});
  for (Case& each : cases) {
    const Index last = static_cast<Index>(each.soup.positions.size()) - 1;
    each.queries = {from({0, last / 3, last / 3 + 1, last})};
  }
  return cases;
}

std::vector<Query> every_source(const TriangleSoup& soup) {
  std::vector<Query> queries;
  for (Index v = 0; v < soup.positions.size(); ++v) queries.push_back(from(v));
  return queries;
}

Case closed_form_case(const std::string& generator, const GeneratorParameters& parameters,
                      const std::vector<Index>& sources) {
  const TriangleSoup soup = generate(generator, parameters);
  std::vector<Query> queries;
  for (const Index source : sources) queries.push_back(from(source));
  if (queries.empty()) queries = every_source(soup);
  return {generator, soup, queries, [=](const Query& query) {
            const Index source = query.sources.front().at.vertex;
            return known_distances(generator, parameters, soup, source).value();
          }};
}

Case plane_case(const std::string& name, const TriangleSoup& soup,
                const std::vector<Query>& queries, const TriangleSoup& flat) {
  return {name, soup, queries, [=](const Query& query) { return straight_lines(flat, query); }};
}

TriangleSoup scaled(TriangleSoup soup, double factor) {
  for (Vec3& p : soup.positions) {
    for (double& c : p) c *= factor;
  }
  return soup;
}

Query within(double limit, Query query) {
  query.limit = limit;
  return query;
}

namespace {
thread_local std::uint64_t required = 0;
}

std::uint64_t requirements() { return required; }

void count_requirement() { ++required; }

void require(Finding finding) {
  count_requirement();
  if (finding) throw *std::move(finding);
}

void require(const std::string& circumstances, Finding finding) {
  require(in(circumstances, std::move(finding)));
}

void require(bool holds, const std::string& otherwise) {
  count_requirement();
  if (!holds) throw Violation{.what = otherwise};
}

Finding same_bits(const Query& query, std::span<const double> got,
                  std::span<const double> expected) {
  return check_distances(query, got, expected, Relation::same_bits);
}

}  // namespace geodesic::harness
