// Every property on every registered solver.
#include "harness/verify/property.h"

#include <algorithm>

#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

struct PropertyOfSolver {
  const Property* property;
  const Description* solver;
};

std::ostream& operator<<(std::ostream& out, const PropertyOfSolver& pair) {
  return out << pair.property->statement << ": " << pair.solver->name;
}

std::vector<PropertyOfSolver> all_pairs() {
  std::vector<PropertyOfSolver> pairs;
  for (const Property& property : all_properties()) {
    for (const Description* solver : registered_solvers()) pairs.push_back({&property, solver});
  }
  return pairs;
}

class PropertyTest : public ::testing::TestWithParam<PropertyOfSolver> {};

TEST_P(PropertyTest, holds) {
  const auto& [property, solver] = GetParam();
  const std::string missing = unclaimed(*property, *solver);
  if (!missing.empty()) GTEST_SKIP() << solver->name << ' ' << missing;
  bool checked = false;
  for (const Case& given : property->cases()) {
    if (too_large(given, *solver)) continue;
    checked = true;
    const Finding finding = check_case(*property, *solver, given);
    EXPECT_FALSE(finding) << property->statement << ", on " << given.mesh << ": " << finding->what;
  }
  if (!checked) GTEST_SKIP() << solver->name << " is not meant for meshes of this size";
}

INSTANTIATE_TEST_SUITE_P(Conformance, PropertyTest, ::testing::ValuesIn(all_pairs()),
                         [](const auto& pair) {
                           return test_name(pair.param.property->name) + "__" +
                                  test_name(pair.param.solver->name);
                         });

TEST(Properties, have_names_of_their_own_that_can_be_typed) {
  for (const Property& property : all_properties()) {
    EXPECT_EQ(find_property(property.name), &property);
    EXPECT_EQ(property.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
              std::string::npos)
        << property.name;
    EXPECT_FALSE(property.statement.empty()) << property.name;
  }
  EXPECT_EQ(find_property("no-such-property"), nullptr);
}

TEST(Properties, are_asked_on_meshes_with_a_query) {
  for (const Property& property : all_properties()) {
    const std::vector<Case> cases = property.cases();
    EXPECT_FALSE(cases.empty()) << property.name;
    for (const Case& given : cases) EXPECT_FALSE(given.queries.empty()) << property.name;
  }
}

TEST(Properties, of_unclean_meshes_are_asked_on_such) {
  int cases = 0;
  for (const Property& property : all_properties()) {
    const bool degenerate = property.name.starts_with("degenerate-");
    const bool non_manifold = property.name.starts_with("non-manifold-");
    if (!degenerate && !non_manifold) continue;
    for (const Case& given : property.cases()) {
      const Mesh mesh(given.soup);
      EXPECT_TRUE(degenerate ? mesh.has_degenerate_faces() : mesh.has_non_manifold_vertices())
          << property.name << " on " << given.mesh;
      ++cases;
    }
  }
  EXPECT_GT(cases, 30);
}

}  // namespace
}  // namespace geodesic::harness
