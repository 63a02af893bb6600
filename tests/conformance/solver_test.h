// What all conformance tests share: each is run for every registered solver, by name. What a solver
// declares about itself decides what is asked of it; no test names one.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "solvers/registry.h"
#include "tests/conformance/distance_checks.h"

namespace geodesic::conformance {

class SolverTest : public ::testing::TestWithParam<std::string> {
 protected:
  const Description& description() const { return *find_solver(GetParam()); }
  const Abilities& abilities() const { return description().abilities; }
  bool is_exact() const { return description().exactness == Exactness::exact; }

  std::unique_ptr<Solver> prepare(const Mesh& mesh) const { return make_solver(GetParam(), mesh); }

  /// Distances by a solver object that has not been used before.
  std::vector<double> solve(const Mesh& mesh, const Query& query) const;
  std::vector<double> solve(const Mesh& mesh, Index source) const;

  /// Equal up to rounding for an exact solver, not below for an upper bound.
  ::testing::AssertionResult correct(const std::vector<double>& got,
                                     const std::vector<double>& want) const;
};

/// Distances by a solver object that may have been used before.
std::vector<double> ask(Solver& solver, const Mesh& mesh, const Query& query,
                        Recording* recording = nullptr);

Query from(Index source);
Query from(const std::vector<Index>& sources);

/// Entry by entry the smaller one.
std::vector<double> least(std::vector<double> a, const std::vector<double>& b);

std::vector<std::string> solver_names();
/// A solver's name as GoogleTest allows it in a test's name: fwp-mmp becomes fwp_mmp.
std::string as_test_name(const ::testing::TestParamInfo<std::string>& info);

}  // namespace geodesic::conformance

/// Runs the tests of a fixture for every registered solver.
#define FOR_EVERY_SOLVER(fixture)                                                        \
  INSTANTIATE_TEST_SUITE_P(Conformance, fixture,                                         \
                           ::testing::ValuesIn(::geodesic::conformance::solver_names()), \
                           ::geodesic::conformance::as_test_name)

/// Ends a test that asks for what the solver does not claim to do.
#define NEEDS(claim) \
  if (!(claim)) GTEST_SKIP() << GetParam() << " does not claim: " << #claim
