// What cannot be reached, and sources that share the work.
#include "tests/conformance/solver_test.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

TriangleSoup with_isolated_vertex_first(const TriangleSoup& soup) {
  return oracles::side_by_side({{{5, 5, 5}}, {}}, soup);
}

class Components : public SolverTest {};

TEST_P(Components, another_component_is_infinitely_far) {
  const TriangleSoup first = oracles::rough_sphere(1, 1, 0.2);
  const TriangleSoup second = oracles::rough_terrain(2, 4, 4, 1);
  const Mesh mesh(oracles::side_by_side(first, second));
  std::vector<double> want = solve(Mesh(first), 3);
  want.resize(mesh.vertex_count(), kInfinity);
  EXPECT_TRUE(correct(solve(mesh, 3), want));
}

TEST_P(Components, a_source_in_each_reaches_both) {
  NEEDS(abilities().multiple_sources);
  const TriangleSoup first = oracles::rough_sphere(1, 1, 0.2);
  const TriangleSoup second = oracles::rough_terrain(2, 4, 4, 1);
  const Mesh mesh(oracles::side_by_side(first, second));
  const Index offset = static_cast<Index>(first.positions.size());
  std::vector<double> want = solve(Mesh(first), 3);
  for (const double d : solve(Mesh(second), 7)) want.push_back(d);
  EXPECT_TRUE(correct(solve(mesh, from({3, offset + 7})), want));
}

TEST_P(Components, an_isolated_vertex_is_infinitely_far_and_disturbs_nothing) {
  const TriangleSoup soup = oracles::rough_terrain(3, 5, 5, 1);
  std::vector<double> want = solve(Mesh(soup), 8);
  want.insert(want.begin(), kInfinity);
  EXPECT_TRUE(identical(solve(Mesh(with_isolated_vertex_first(soup)), 9), want));
}

TEST_P(Components, an_isolated_source_reaches_itself_only) {
  const Mesh mesh(with_isolated_vertex_first(oracles::rough_terrain(3, 5, 5, 1)));
  std::vector<double> want(mesh.vertex_count(), kInfinity);
  want[0] = 0;
  EXPECT_TRUE(identical(solve(mesh, 0), want));
}

TEST_P(Components, a_mesh_without_faces_has_only_its_source) {
  const Mesh mesh(TriangleSoup{{{0, 0, 0}, {1, 0, 0}}, {}});
  EXPECT_TRUE(identical(solve(mesh, 1), {kInfinity, 0}));
}

TEST_P(Components, a_single_triangle_has_its_edges_for_distances) {
  const Mesh mesh(TriangleSoup{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  EXPECT_TRUE(agree(solve(mesh, 0), {0, 3, 4}));
  EXPECT_TRUE(agree(solve(mesh, 1), {3, 0, 5}));
}

FOR_EVERY_SOLVER(Components);

class MultipleSources : public SolverTest {};

TEST_P(MultipleSources, give_the_least_of_single_sources) {
  NEEDS(abilities().multiple_sources);
  NEEDS(is_exact());
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    const Index last = mesh.vertex_count() - 1;
    std::vector<double> want(mesh.vertex_count(), kInfinity);
    const std::vector<Index> sources = {0, last / 3, last / 3 + 1, last};
    for (const Index source : sources) want = least(want, solve(mesh, source));
    EXPECT_TRUE(agree(solve(mesh, from(sources)), want)) << name;
  }
}

TEST_P(MultipleSources, named_twice_count_once) {
  NEEDS(abilities().multiple_sources);
  const Mesh mesh(oracles::rough_sphere(4, 1, 0.3));
  EXPECT_TRUE(correct(solve(mesh, from({5, 5})), solve(mesh, 5)));
}

TEST_P(MultipleSources, may_be_all_vertices) {
  NEEDS(abilities().multiple_sources);
  const Mesh mesh(oracles::rough_sphere(4, 1, 0.3));
  std::vector<Index> all;
  for (Index v = 0; v < mesh.vertex_count(); ++v) all.push_back(v);
  EXPECT_TRUE(identical(solve(mesh, from(all)), std::vector<double>(mesh.vertex_count(), 0)));
}

FOR_EVERY_SOLVER(MultipleSources);

class InitialDistances : public SolverTest {};

TEST_P(InitialDistances, are_added_to_every_path_from_their_source) {
  NEEDS(abilities().initial_distances);
  const Mesh mesh(oracles::rough_torus(5, 12, 7, 0.2));
  std::vector<double> want = solve(mesh, 10);
  for (double& d : want) d += 2.5;
  Query query;
  query.sources = {{10, 2.5}};
  EXPECT_TRUE(agree(solve(mesh, query), want));
}

TEST_P(InitialDistances, decide_which_source_is_nearest) {
  NEEDS(abilities().initial_distances && abilities().multiple_sources && is_exact());
  const Mesh mesh(oracles::rough_torus(5, 12, 7, 0.2));
  std::vector<double> late = solve(mesh, 50);
  for (double& d : late) d += 1.25;
  Query query;
  query.sources = {{50, 1.25}, {10, 0}};
  EXPECT_TRUE(agree(solve(mesh, query), least(late, solve(mesh, 10))));
}

TEST_P(InitialDistances, too_large_ones_make_a_source_an_ordinary_vertex) {
  NEEDS(abilities().initial_distances && abilities().multiple_sources);
  const Mesh mesh(oracles::rough_torus(5, 12, 7, 0.2));
  Query query;
  query.sources = {{50, 1000}, {10, 0}, {10, 3}};
  EXPECT_TRUE(correct(solve(mesh, query), solve(mesh, 10)));
}

FOR_EVERY_SOLVER(InitialDistances);

}  // namespace
}  // namespace geodesic::conformance
