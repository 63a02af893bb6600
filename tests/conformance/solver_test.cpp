#include "tests/conformance/solver_test.h"

#include <algorithm>

namespace geodesic::conformance {

std::vector<double> SolverTest::solve(const Mesh& mesh, const Query& query) const {
  return ask(*prepare(mesh), mesh, query);
}

std::vector<double> SolverTest::solve(const Mesh& mesh, Index source) const {
  return solve(mesh, from(source));
}

::testing::AssertionResult SolverTest::correct(const std::vector<double>& got,
                                               const std::vector<double>& want) const {
  return is_exact() ? agree(got, want) : bound_from_above(got, want);
}

std::vector<double> ask(Solver& solver, const Mesh& mesh, const Query& query,
                        Recording* recording) {
  std::vector<double> distances(mesh.vertex_count());
  solver.solve(query, distances, recording);
  return distances;
}

Query from(Index source) { return from(std::vector<Index>{source}); }

Query from(const std::vector<Index>& sources) {
  Query query;
  for (const Index v : sources) query.sources.push_back({v, 0});
  return query;
}

std::vector<double> least(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] = std::min(a[v], b[v]);
  return a;
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const Description* description : registered_solvers()) names.push_back(description->name);
  return names;
}

std::string as_test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace geodesic::conformance
