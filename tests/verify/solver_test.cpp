#include "tests/verify/solver_test.h"

#include <algorithm>

namespace geodesic::harness {

::testing::AssertionResult nothing(const Finding& finding) {
  if (!finding) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << finding->what;
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const Description* description : registered_solvers()) names.push_back(description->name);
  return names;
}

std::string test_name(std::string name) {
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace geodesic::harness
