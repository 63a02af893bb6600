// Distances against plane geometry: the closed forms of generated meshes, and planes that the test
// itself tilts and stirs.
#include <cmath>

#include "datasets/generators/generators.h"
#include "tests/conformance/solver_test.h"
#include "tests/oracles/random.h"

namespace geodesic::conformance {
namespace {

using generators::generate;
using generators::Parameters;
using oracles::Random;

class ClosedFormTest : public SolverTest {
 protected:
  /// Checks the distances between all pairs of vertices.
  /// @param wanted gives those from a source
  template <typename Distances>
  void check_all(const TriangleSoup& soup, Distances wanted) const {
    const Mesh mesh(soup);
    const auto solver = prepare(mesh);
    for (Index source = 0; source < mesh.vertex_count(); ++source) {
      ASSERT_TRUE(correct(ask(*solver, mesh, from(source)), wanted(source)))
          << "from vertex " << source;
    }
  }

  void check(const std::string& generator, const Parameters& parameters) const {
    const TriangleSoup soup = generate(generator, parameters);
    check_all(soup, [&](Index source) {
      return generators::known_distances(generator, parameters, soup, source).value();
    });
  }

  /// Of a convex piece of a plane, wherever it lies in space.
  /// @param flat the same mesh in the plane z = 0, before rounding by a tilt
  void check_euclid(const TriangleSoup& soup, const TriangleSoup& flat) const {
    check_all(soup, [&](Index source) {
      std::vector<double> lines;
      for (const auto& [x, y, z] : flat.positions) {
        lines.push_back(std::hypot(x - flat.positions[source][0], y - flat.positions[source][1]));
      }
      return lines;
    });
  }
};

const Parameters kGrid = {{"columns", 12}, {"rows", 9}};

/// Moves vertices of kGrid pseudo-randomly within the plane by up to 0.28 cells; those of the
/// border move along it. Hardly any line between vertices then runs through a third.
TriangleSoup stirred_grid() {
  Random random(7);
  TriangleSoup soup = generate("grid", kGrid);
  for (auto& [x, y, z] : soup.positions) {
    const bool border_x = x == 0 || x == 12, border_y = y == 0 || y == 9;
    if (!border_x) x += 0.28 * random.between(-1, 1);
    if (!border_y) y += 0.28 * random.between(-1, 1);
  }
  return soup;
}

/// Turned about two axes, so that coordinates of a plane get rounding errors.
TriangleSoup tilted(TriangleSoup soup) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  for (Vec3& p : soup.positions) p = {c * p[0], c * p[1] + s * s * p[0], s * p[1] - s * c * p[0]};
  return soup;
}

class FlatGrid : public ClosedFormTest {};
TEST_P(FlatGrid, distances_equal_euclid) { check("grid", kGrid); }
TEST_P(FlatGrid, distances_equal_euclid_when_stirred) {
  check_euclid(stirred_grid(), stirred_grid());
}
TEST_P(FlatGrid, distances_equal_euclid_when_tilted) {
  check_euclid(tilted(generate("grid", kGrid)), generate("grid", kGrid));
  check_euclid(tilted(stirred_grid()), stirred_grid());
}
FOR_EVERY_SOLVER(FlatGrid);

class Box : public ClosedFormTest {
 protected:
  void check_box(Index x, Index y, Index z) const {
    check("box", {{"x-cells", x}, {"y-cells", y}, {"z-cells", z}});
  }
};
TEST_P(Box, distances_on_a_cube_equal_the_shortest_unfolding) {
  check_box(1, 1, 1);
  check_box(4, 4, 4);
}
TEST_P(Box, distances_in_a_long_room_equal_the_shortest_unfolding) { check_box(8, 3, 3); }
TEST_P(Box, distances_on_a_slab_equal_the_shortest_unfolding) { check_box(7, 5, 1); }
FOR_EVERY_SOLVER(Box);

class Cone : public ClosedFormTest {};
TEST_P(Cone, distances_follow_from_the_angle_at_the_apex) {
  check("cone", {{"sectors", 7}, {"angle", 290}, {"rings", 5}});
  check("cone", {{"sectors", 4}, {"angle", 90}, {"rings", 5}});  // sharp: most paths go around
}
TEST_P(Cone, distances_on_a_flat_disk_equal_euclid) {
  TriangleSoup disk = generate("cone", {{"sectors", 6}, {"rings", 5}});
  for (Vec3& p : disk.positions) p[2] = 0;
  check_euclid(disk, disk);
}
FOR_EVERY_SOLVER(Cone);

class Saddle : public ClosedFormTest {};
TEST_P(Saddle, paths_are_straight_below_pi_and_bend_at_the_apex_above) {
  check("saddle-cone", {{"sectors", 6}, {"sector-angle", 72}, {"rings", 5}});
  check("saddle-cone", {{"sectors", 8}, {"sector-angle", 90}, {"rings", 5}});
}
TEST_P(Saddle, a_hardly_curved_saddle_is_exact_too) {
  for (const double excess : {1e-4, 1e-10}) {  // degrees, about 1e-6 and 1e-12 rad
    check("saddle-cone", {{"sectors", 6}, {"sector-angle", 60 + excess}, {"rings", 5}});
  }
}
FOR_EVERY_SOLVER(Saddle);

class Cylinder : public ClosedFormTest {};
TEST_P(Cylinder, distances_equal_those_of_the_unrolled_strip) {
  check("cylinder", {{"sides", 18}, {"rows", 6}});
  check("cylinder", {{"sides", 3}, {"rows", 9}});
}
FOR_EVERY_SOLVER(Cylinder);

class SquareWithHole : public ClosedFormTest {};
TEST_P(SquareWithHole, paths_bend_at_the_corners_of_the_hole) {
  check("square-with-hole", {{"hole", 3}, {"rim", 3}});
  check("square-with-hole", {{"hole", 6}, {"rim", 2}});
}
FOR_EVERY_SOLVER(SquareWithHole);

}  // namespace
}  // namespace geodesic::conformance
