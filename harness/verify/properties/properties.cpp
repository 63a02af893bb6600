#include "harness/verify/properties/properties.h"

#include <cmath>

namespace geodesic::conformance {

Finding distances_are_right(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) {
    const auto got = ask(*solver, trial.mesh(), query);
    if (auto wrong = trial.correct(query, got, trial.expected(query))) return wrong;
    if (query.limit < kInfinity) continue;  // beyond it, distances become infinite
    if (auto wrong = satisfies_edges(trial.mesh(), query, got, trial.tolerance())) return wrong;
  }
  return {};
}

std::vector<Case> random_mesh_cases(const std::vector<Query>& queries) {
  std::vector<Case> cases;
  for (const auto& [name, soup] : random_meshes()) cases.push_back({name, soup, queries});
  return cases;
}

std::vector<Query> some_sources(const TriangleSoup& soup) {
  const Index count = static_cast<Index>(soup.positions.size());
  return {from(0), from(count / 2), from(count - 1)};
}

std::vector<double> straight_lines(const TriangleSoup& soup, const Query& query) {
  const Vec3& s = soup.positions[query.sources.front().vertex];
  std::vector<double> lines;
  for (const Vec3& p : soup.positions) {
    lines.push_back(std::hypot(p[0] - s[0], p[1] - s[1], p[2] - s[2]));
  }
  return lines;
}

}  // namespace geodesic::conformance
