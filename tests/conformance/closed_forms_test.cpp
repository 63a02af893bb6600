// Distances against plane geometry.
#include "tests/oracles/closed_forms.h"
#include "tests/conformance/solver_test.h"

namespace geodesic::conformance {
namespace {

using oracles::ClosedForm;

class ClosedFormTest : public SolverTest {
 protected:
  /// Checks the distances between all pairs of vertices.
  void check(const ClosedForm& form) const {
    const Mesh mesh(form.soup);
    const auto solver = prepare(mesh);
    for (Index source = 0; source < mesh.vertex_count(); ++source) {
      std::vector<double> want;
      for (Index v = 0; v < mesh.vertex_count(); ++v) want.push_back(form.distance(source, v));
      ASSERT_TRUE(correct(ask(*solver, mesh, from(source)), want)) << "from vertex " << source;
    }
  }
};

class FlatGrid : public ClosedFormTest {};
TEST_P(FlatGrid, distances_equal_euclid) { check(oracles::flat_grid(12, 9)); }
TEST_P(FlatGrid, distances_equal_euclid_when_shaken) { check(oracles::flat_grid(12, 9, 0.28)); }
TEST_P(FlatGrid, distances_equal_euclid_when_tilted) {
  check(oracles::flat_grid(12, 9, 0, true));
  check(oracles::flat_grid(12, 9, 0.28, true));
}
FOR_EVERY_SOLVER(FlatGrid);

class Box : public ClosedFormTest {};
TEST_P(Box, distances_on_a_cube_equal_the_shortest_unfolding) {
  check(oracles::box({1, 1, 1}, 1));
  check(oracles::box({1, 1, 1}, 4));
}
TEST_P(Box, distances_in_a_long_room_equal_the_shortest_unfolding) {
  check(oracles::box({30, 12, 12}, 4));  // Dudeney's spider and fly: paths over five faces
}
TEST_P(Box, distances_on_a_slab_equal_the_shortest_unfolding) {
  check(oracles::box({3, 2, 0.25}, 5));
}
FOR_EVERY_SOLVER(Box);

class Cone : public ClosedFormTest {};
TEST_P(Cone, distances_follow_from_the_angle_at_the_apex) {
  check(oracles::cone(7, 0.6, 5));
  check(oracles::cone(4, 1.3, 5));  // a sharp one: most paths go around
}
TEST_P(Cone, distances_on_a_flat_disk_equal_euclid) { check(oracles::cone(6, 0, 5)); }
FOR_EVERY_SOLVER(Cone);

class Saddle : public ClosedFormTest {};
TEST_P(Saddle, paths_are_straight_below_pi_and_bend_at_the_apex_above) {
  check(oracles::saddle(6, 0.5, 5));
  check(oracles::saddle(8, 1.0, 5));
}
TEST_P(Saddle, a_hardly_curved_saddle_is_exact_too) {
  check(oracles::saddle(6, 1e-3, 5));
  check(oracles::saddle(6, 1e-6, 5));
}
FOR_EVERY_SOLVER(Saddle);

class Cylinder : public ClosedFormTest {};
TEST_P(Cylinder, distances_equal_those_of_the_unrolled_strip) {
  check(oracles::cylinder(9, 6, 2));
  check(oracles::cylinder(3, 5, 4));
}
FOR_EVERY_SOLVER(Cylinder);

class SquareWithHole : public ClosedFormTest {};
TEST_P(SquareWithHole, paths_bend_at_the_corners_of_the_hole) {
  check(oracles::square_with_hole(9, 3));
  check(oracles::square_with_hole(10, 6));
}
FOR_EVERY_SOLVER(SquareWithHole);

}  // namespace
}  // namespace geodesic::conformance
