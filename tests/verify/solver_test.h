// What tests of solvers share that are no properties (harness/verify): each is run for every
// registered solver, by name; no test names one.
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

/// Success unless something was found.
::testing::AssertionResult nothing(const Finding& finding);

std::vector<std::string> solver_names();
/// A name as GoogleTest allows it in a test's: fwp-mmp becomes fwp_mmp.
std::string test_name(std::string name);

}  // namespace geodesic::harness

/// Runs the tests of a fixture for every registered solver.
#define FOR_EVERY_SOLVER(fixture)                                                     \
  INSTANTIATE_TEST_SUITE_P(                                                           \
      Conformance, fixture, ::testing::ValuesIn(::geodesic::harness::solver_names()), \
      [](const auto& solver) { return ::geodesic::harness::test_name(solver.param); })
