// Fixture for tests of solvers that are not properties (harness/verify). Each test runs for every
// registered solver; no test names a solver.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/verify/property.h"

namespace geodesic::harness {

class SolverTest : public ::testing::TestWithParam<std::string> {
 protected:
  const Description& description() const { return *find_solver(GetParam()); }
  const Abilities& abilities() const { return description().abilities; }
  std::unique_ptr<Solver> prepare(const Mesh& mesh) const { return make_solver(GetParam(), mesh); }
};

/// Success if the finding is empty.
::testing::AssertionResult nothing(const Finding& finding);

std::vector<std::string> solver_names();
/// A solver's name in the characters that GoogleTest allows: fwp-mmp becomes fwp_mmp.
std::string test_name(std::string name);

}  // namespace geodesic::harness

/// Runs the tests of a fixture for every registered solver.
#define FOR_EVERY_SOLVER(fixture)                                                     \
  INSTANTIATE_TEST_SUITE_P(                                                           \
      Conformance, fixture, ::testing::ValuesIn(::geodesic::harness::solver_names()), \
      [](const auto& solver) { return ::geodesic::harness::test_name(solver.param); })
