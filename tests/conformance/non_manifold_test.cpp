// Vertices that several fans of faces share, and edges that no path may cross. A solver that does
// not support them must refuse the mesh.
#include "tests/conformance/solver_test.h"
#include "tests/oracles/brute_force.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class NonManifold : public SolverTest {
 protected:
  void check(const TriangleSoup& soup, Index source) const {
    const Mesh mesh(soup);
    ASSERT_TRUE(mesh.has_non_manifold_vertices());
    if (!abilities().non_manifold_vertices) {
      EXPECT_THROW(prepare(mesh), std::invalid_argument);
      return;
    }
    const auto got = solve(mesh, source);
    EXPECT_TRUE(correct(got, oracles::brute_force_distances(mesh, source)))
        << "from vertex " << source;
    EXPECT_TRUE(satisfies_edges(mesh, got)) << "from vertex " << source;
  }
};

/// Two meshes joined at one vertex, number `a` of the first and `b` of the second.
TriangleSoup joined_at_vertex(const TriangleSoup& first, Index a, const TriangleSoup& second,
                              Index b) {
  const Index offset = static_cast<Index>(first.positions.size());
  TriangleSoup both = oracles::side_by_side(first, second);
  for (std::size_t v = offset; v < both.positions.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      both.positions[v][k] += first.positions[a][k] - second.positions[b][k];
    }
  }
  for (Triangle& t : both.triangles) {
    for (Index& v : t) v = v == offset + b ? a : v;
  }
  return both;
}

TEST_P(NonManifold, paths_go_through_a_vertex_that_joins_two_terrains) {
  const auto soup = joined_at_vertex(oracles::rough_terrain(1, 5, 5, 1), 35,
                                     oracles::rough_terrain(2, 5, 5, 1), 0);
  for (const Index source : {0u, 35u, 50u}) check(soup, source);
}

TEST_P(NonManifold, paths_go_through_a_vertex_that_joins_two_closed_surfaces) {
  const auto soup =
      joined_at_vertex(oracles::rough_sphere(3, 1, 0.2), 7, oracles::rough_sphere(4, 1, 0.2), 9);
  for (const Index source : {0u, 7u, 60u}) check(soup, source);
}

TEST_P(NonManifold, paths_cross_an_edge_of_three_faces_at_its_ends_only) {
  TriangleSoup soup = oracles::rough_terrain(5, 6, 6, 1);
  soup.positions.push_back({3, 3, 5});
  const auto [a, b, c] = soup.triangles[30];
  soup.triangles.push_back({b, a, static_cast<Index>(soup.positions.size() - 1)});
  for (const Index source : {0u, 20u, 49u}) check(soup, source);
}

TEST_P(NonManifold, paths_cross_the_edges_of_a_flipped_face_at_their_ends_only) {
  TriangleSoup soup = oracles::rough_terrain(6, 6, 6, 1);
  std::swap(soup.triangles[33][0], soup.triangles[33][1]);
  for (const Index source : {0u, 20u, 48u}) check(soup, source);
}

TEST_P(NonManifold, ragged_surfaces_equal_brute_force) {
  for (std::uint64_t seed = 70; seed < 80; ++seed) {
    check(oracles::with_missing_faces(oracles::rough_terrain(seed, 9, 9, 1.5), seed, 4), 44);
    check(oracles::with_missing_faces(oracles::rough_sphere(seed, 2, 0.3), seed, 4), 44);
  }
}

FOR_EVERY_SOLVER(NonManifold);

}  // namespace
}  // namespace geodesic::conformance
