// Distances where no closed form is known: against brute force, and on larger meshes between the
// exact solvers, CGAL among them where it is installed.
#include "tests/conformance/solver_test.h"
#include "tests/oracles/brute_force.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class RandomMeshes : public SolverTest {};

TEST_P(RandomMeshes, distances_equal_brute_force) {
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    const auto solver = prepare(mesh);
    for (const Index source : {Index{0}, mesh.vertex_count() / 2, mesh.vertex_count() - 1}) {
      const auto got = ask(*solver, mesh, from(source));
      EXPECT_TRUE(correct(got, oracles::brute_force_distances(mesh, source)))
          << name << " from vertex " << source;
      EXPECT_TRUE(satisfies_edges(mesh, got)) << name << " from vertex " << source;
    }
  }
}

TEST_P(RandomMeshes, distances_equal_brute_force_on_many_small_ones) {
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    for (const TriangleSoup& soup :
         {oracles::rough_terrain(seed, 5, 4, 2), oracles::rough_sphere(seed, 1, 0.5)}) {
      const Mesh mesh(soup);
      const Index source = static_cast<Index>(seed) % mesh.vertex_count();
      EXPECT_TRUE(correct(solve(mesh, source), oracles::brute_force_distances(mesh, source)))
          << "seed " << seed << ", " << mesh.face_count() << " faces, from vertex " << source;
    }
  }
}

TEST_P(RandomMeshes, distances_are_symmetric) {
  NEEDS(is_exact());
  const Mesh mesh(oracles::rough_terrain(11, 12, 12, 3));
  const auto solver = prepare(mesh);
  std::vector<std::vector<double>> between;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    between.push_back(ask(*solver, mesh, from(v)));
  }
  for (Index a = 0; a < mesh.vertex_count(); ++a) {
    std::vector<double> back;
    for (Index b = 0; b < mesh.vertex_count(); ++b) back.push_back(between[b][a]);
    ASSERT_TRUE(agree(between[a], back)) << "from vertex " << a << " and back";
  }
}

FOR_EVERY_SOLVER(RandomMeshes);

// The one that the others are compared with: an independent oracle (CGAL) if there is one, else the
// comparison is between this project's own.
std::string reference_solver(const Mesh& mesh) {
  std::string reference;
  for (const Description* solver : registered_solvers()) {
    if (solver->exactness != Exactness::exact || solver->by_name_only) continue;
    if (solver->abilities.max_vertices < mesh.vertex_count()) continue;
    if (reference.empty() || solver->independent_oracle) reference = solver->name;
  }
  return reference;
}

class Rivals : public SolverTest {
 protected:
  void compare(const TriangleSoup& soup) const {
    const Mesh mesh(soup);
    const std::string reference = reference_solver(mesh);
    if (reference.empty()) GTEST_SKIP() << "no exact solver is registered";
    if (mesh.vertex_count() > abilities().max_vertices) {
      GTEST_SKIP() << GetParam() << " is for at most " << abilities().max_vertices << " vertices";
    }
    const auto solver = prepare(mesh), rival = make_solver(reference, mesh);
    for (const Index source : {Index{0}, mesh.vertex_count() / 2}) {
      const auto got = ask(*solver, mesh, from(source));
      EXPECT_TRUE(correct(got, ask(*rival, mesh, from(source))))
          << "against " << reference << " from vertex " << source;
      EXPECT_TRUE(satisfies_edges(mesh, got)) << "from vertex " << source;
    }
  }
};

TEST_P(Rivals, agree_on_a_terrain) { compare(oracles::rough_terrain(21, 30, 30, 1)); }
TEST_P(Rivals, agree_on_a_sphere) { compare(oracles::rough_sphere(22, 3, 0.05)); }
TEST_P(Rivals, agree_on_a_spiky_sphere) { compare(oracles::rough_sphere(23, 3, 0.4)); }
TEST_P(Rivals, agree_on_a_torus) { compare(oracles::rough_torus(24, 40, 20, 0.1)); }
TEST_P(Rivals, agree_on_a_terrain_with_holes) {
  compare(oracles::with_holes(oracles::rough_terrain(25, 30, 30, 0.5), 25, 30));
}

FOR_EVERY_SOLVER(Rivals);

}  // namespace
}  // namespace geodesic::conformance
