// Every property on every registered solver.
#include "harness/verify/property.h"

#include <algorithm>

#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

/// All registered solvers, and one that divides every mesh into several regions.
std::vector<const Description*> solvers_and_regional_one() {
  std::vector<const Description*> solvers = registered_solvers();
  if (find_solver("edge-based") == nullptr) return solvers;
  solvers.push_back(&solver_named("edge-based?threads=2&region-size=20"));
  return solvers;
}

class PropertyTest : public ::testing::TestWithParam<const Property*> {};

// One process runs all solvers. It prints each name first, in case the solver ends the process.
TEST_P(PropertyTest, holds) {
  const Property& property = *GetParam();
  const std::vector<Case> cases = property.cases();
  int checked = 0;
  for (const Description* solver : solvers_and_regional_one()) {
    if (!unclaimed(property, *solver).empty()) continue;
    std::cout << solver->name << std::endl;
    for (const Case& given : cases) {
      if (too_large(given, *solver)) continue;
      // Ten thousand regions of 20 vertices take a hundred times as long as one.
      const bool has_regions = solver->name.find('?') != std::string::npos;
      if (has_regions && given.soup.triangles.size() > 50'000) continue;
      try {
        const Finding finding = check_case(property, *solver, given);
        EXPECT_FALSE(finding) << solver->name << " on " << given.mesh << ": " << property.statement
                              << ": " << finding->what;
        ++checked;
      } catch (const NothingCompared& nothing) {
        std::cout << "  " << nothing.what() << std::endl;
      }
    }
  }
  if (checked == 0) GTEST_SKIP() << "no registered solver has what this property is about";
}

std::vector<const Property*> every_property() {
  std::vector<const Property*> properties;
  for (const Property& property : all_properties()) properties.push_back(&property);
  return properties;
}

INSTANTIATE_TEST_SUITE_P(Conformance, PropertyTest, ::testing::ValuesIn(every_property()),
                         [](const auto& each) { return test_name(each.param->name); });

TEST(Properties, have_names_of_their_own_that_can_be_typed) {
  for (const Property& property : all_properties()) {
    EXPECT_EQ(&property_named(property.name), &property);
    EXPECT_EQ(property.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
              std::string::npos)
        << property.name;
    EXPECT_FALSE(property.statement.empty()) << property.name;
  }
}

TEST(Properties, are_asked_on_meshes_with_a_query) {
  for (const Property& property : all_properties()) {
    const std::vector<Case> cases = property.cases();
    EXPECT_FALSE(cases.empty()) << property.name;
    for (const Case& given : cases) EXPECT_FALSE(given.queries.empty()) << property.name;
  }
}

TEST(Properties, that_compare_nothing_do_not_hold) {
  const Property idle{"idle", "", [] { return std::vector<Case>(); }, [](const Trial&) {}};
  const TriangleSoup triangle{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {9, 9, 9}}, {{0, 1, 2}}};
  const Case isolated{"a triangle and a point", triangle, {from(3)}};
  const Case points{"two points", {{{0, 0, 0}, {1, 0, 0}}, {}}, {from(0)}};
  const auto compare_nothing = [](const Property& property, const Case& given) {
    const Mesh mesh = given.build();
    for (const Description* solver : registered_solvers()) {
      if (!unclaimed(property, *solver).empty() || !unsupported(*solver, mesh).empty()) continue;
      EXPECT_THROW(check_case(property, *solver, given), NothingCompared)
          << property.name << " by " << solver->name;
    }
  };
  compare_nothing(idle, isolated);
  compare_nothing(property_named("limit-keeps-what-is-nearer-and-drops-what-is-farther"), isolated);
  for (const char* name : {"paths-begin-in-faces-and-on-edges-too",
                           "sources-in-faces-and-on-edges-equal-inserted-vertices",
                           "targets-in-faces-and-on-edges-equal-inserted-vertices"}) {
    compare_nothing(property_named(name), points);
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
