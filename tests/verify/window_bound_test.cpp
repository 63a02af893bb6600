// An endless solve is distinguished from a long one and ends with an error.
#include "solvers/core/window_bound.h"

#include "meshes/connectivity.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/lowered_window_bound.h"
#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

constexpr std::uint64_t kFew = 20;  // windows; enough for a triangle, too few for a sphere

// A sphere of 80 faces, and a triangle: vertices 42 to 44.
TriangleSoup sphere_and_triangle() {
  return side_by_side(rough_sphere(1, 1, 0.3), {{{9, 0, 0}, {12, 0, 0}, {9, 4, 0}}, {{0, 1, 2}}});
}

class WindowBound : public SolverTest {
 protected:
  void SetUp() override {
    const bool has_windows =
        description().exactness == Exactness::exact && !description().independent_oracle;
    if (!has_windows) GTEST_SKIP() << GetParam() << " propagates no windows of this project";
  }

  const Mesh mesh_{sphere_and_triangle()};
};

TEST_P(WindowBound, ends_a_solve_with_an_error_that_names_the_mesh) {
  const LoweredWindowBound lowered(kFew);
  const auto solver = prepare(mesh_);
  for (const bool recorded : {false, true}) {
    Recording recording;
    try {
      solve_with(*solver, mesh_, from(0), recorded ? &recording : nullptr);
      FAIL() << "the bound was not seen";
    } catch (const EndlessPropagation& error) {
      EXPECT_STREQ(error.what(),
                   "endless propagation: more than 20 windows on a mesh of 81 faces; please report "
                   "this mesh");
    }
  }
}

TEST_P(WindowBound, leaves_an_object_that_solves_on) {
  const LoweredWindowBound lowered(kFew);
  const auto solver = prepare(mesh_);
  for (int time = 0; time < 2; ++time) {
    EXPECT_THROW(solve_with(*solver, mesh_, from(0)), EndlessPropagation);
    const auto distances = solve_with(*solver, mesh_, from(42));
    EXPECT_EQ(distances[0], kInfinity);
    EXPECT_EQ(std::vector<double>(distances.begin() + 42, distances.end()),
              (std::vector<double>{0, 3, 4}));
  }
}

FOR_EVERY_SOLVER(WindowBound);

TEST(WindowBound, is_above_the_square_of_half_edges_up_to_three_hundred_thousand_faces) {
  for (const Index cells : {1u, 10u, 100u}) {
    const Mesh mesh(rough_terrain(1, cells, cells, 1));
    const std::uint64_t half_edges = mesh.half_edge_count();
    EXPECT_GT(window_bound(mesh), half_edges * half_edges);
  }
}

}  // namespace
}  // namespace geodesic::harness
