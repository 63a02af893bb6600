// Queries: the distance limit, and what is refused.
#include <algorithm>
#include <cmath>

#include "tests/conformance/solver_test.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class DistanceLimit : public SolverTest {
 protected:
  const Mesh mesh_{oracles::rough_terrain(61, 12, 12, 1)};

  std::vector<double> within(double limit) const {
    Query query = from(40);
    query.limit = limit;
    return solve(mesh_, query);
  }
};

TEST_P(DistanceLimit, keeps_what_is_nearer_and_drops_what_is_farther) {
  NEEDS(abilities().distance_limit);
  const std::vector<double> all = solve(mesh_, 40);
  std::vector<double> sorted = all;
  std::ranges::sort(sorted);
  for (const std::size_t rank : {std::size_t{1}, sorted.size() / 3, sorted.size() - 2}) {
    const double limit = (sorted[rank] + sorted[rank + 1]) / 2;
    std::vector<double> want = all;
    for (double& d : want) d = d > limit ? kInfinity : d;
    const std::vector<double> got = within(limit);
    EXPECT_TRUE(is_exact() ? agree(got, want) : bound_from_above(got, want)) << "limit " << limit;
  }
}

TEST_P(DistanceLimit, of_zero_keeps_the_source) {
  NEEDS(abilities().distance_limit);
  std::vector<double> want(mesh_.vertex_count(), kInfinity);
  want[40] = 0;
  EXPECT_TRUE(identical(within(0), want));
}

TEST_P(DistanceLimit, beyond_the_mesh_changes_nothing) {
  NEEDS(abilities().distance_limit);
  EXPECT_TRUE(correct(within(1e6), solve(mesh_, 40)));
}

TEST_P(DistanceLimit, drops_sources_that_start_beyond_it) {
  NEEDS(abilities().distance_limit && abilities().initial_distances);
  NEEDS(abilities().multiple_sources);
  Query query;
  query.sources = {{40, 0}, {0, 5}};
  query.limit = 1e-3;
  std::vector<double> want(mesh_.vertex_count(), kInfinity);
  want[40] = 0;
  EXPECT_TRUE(identical(solve(mesh_, query), want));
}

FOR_EVERY_SOLVER(DistanceLimit);

class QueryErrors : public SolverTest {
 protected:
  void expect_refused(const Query& query) const {
    EXPECT_THROW(solve(mesh_, query), std::invalid_argument);
  }
  const Mesh mesh_{oracles::rough_terrain(62, 3, 3, 1)};
};

TEST_P(QueryErrors, no_source) { expect_refused(Query{}); }

TEST_P(QueryErrors, a_source_that_is_not_in_the_mesh) {
  expect_refused(from(mesh_.vertex_count()));
  expect_refused(from(kNone));
}

TEST_P(QueryErrors, an_initial_distance_that_is_negative_or_not_finite) {
  for (const double d : {-1.0, -1e-300, kInfinity, std::nan("")}) {
    Query query;
    query.sources = {{0, d}};
    expect_refused(query);
  }
}

TEST_P(QueryErrors, a_limit_that_is_negative_or_not_a_number) {
  for (const double limit : {-1.0, -kInfinity, std::nan("")}) {
    Query query = from(0);
    query.limit = limit;
    expect_refused(query);
  }
}

TEST_P(QueryErrors, room_for_too_few_or_too_many_distances) {
  const auto solver = prepare(mesh_);
  std::vector<double> few(mesh_.vertex_count() - 1), many(mesh_.vertex_count() + 1);
  EXPECT_THROW(solver->solve(from(0), few), std::invalid_argument);
  EXPECT_THROW(solver->solve(from(0), many), std::invalid_argument);
}

TEST_P(QueryErrors, an_ability_that_the_solver_lacks) {
  if (!abilities().multiple_sources) expect_refused(from({0, 1}));
  Query late;
  late.sources = {{0, 1.0}};
  if (!abilities().initial_distances) expect_refused(late);
  Query limited = from(0);
  limited.limit = 1;
  if (!abilities().distance_limit) expect_refused(limited);
}

TEST_P(QueryErrors, name_the_solver) {
  try {
    solve(mesh_, Query{});
    FAIL() << "a query without sources was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam()), std::string::npos) << error.what();
  }
}

FOR_EVERY_SOLVER(QueryErrors);

}  // namespace
}  // namespace geodesic::conformance
