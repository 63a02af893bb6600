#include "solvers/core/unit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/core/mesh.h"

namespace geodesic {
namespace {

std::vector<Vec3> triangle(double size) { return {{0, 0, 0}, {3 * size, 0, 0}, {0, 4 * size, 0}}; }

constexpr Triangle kFace[] = {{0, 1, 2}};

TEST(Unit, is_one_for_ordinary_extents_and_for_a_point) {
  for (const double size : {1e-30, 1e-6, 1.0, 1e6, 1e30}) {
    EXPECT_TRUE(Unit::of(triangle(size)).is_one()) << size;
  }
  EXPECT_TRUE(Unit::of(triangle(0)).is_one());
  EXPECT_TRUE(Unit::of({}).is_one());
}

TEST(Unit, brings_the_extent_into_one_to_two) {
  for (const double size : {1e-280, 1e-150, 1e-40, 1e40, 1e150, 1e280}) {
    const Unit unit = Unit::of(triangle(size));
    const double extent = unit.in_unit(triangle(size))[2][1];
    EXPECT_GE(extent, 1) << size;
    EXPECT_LT(extent, 2) << size;
    EXPECT_EQ(unit.in_mesh(extent), 4 * size);
  }
}

TEST(Mesh, has_frames_of_faces_whose_squared_lengths_leave_the_range_of_a_double) {
  for (const double size : {1e-280, 1e-150, 1e150, 1e280}) {
    const Mesh mesh(triangle(size), kFace);
    EXPECT_FALSE(mesh.has_degenerate_faces());
    EXPECT_DOUBLE_EQ(mesh.half_edge(0).length, 3 * size);
    EXPECT_DOUBLE_EQ(mesh.half_edge(0).apex_y, 4 * size);
    EXPECT_DOUBLE_EQ(mesh.half_edge(1).length, 5 * size);
    EXPECT_DOUBLE_EQ(mesh.mean_edge_length(), 4 * size);
  }
}

TEST(Mesh, refuses_extents_of_which_distances_would_leave_the_range_of_a_double) {
  for (const double size : {1e-300, 1e300}) {
    EXPECT_THROW(Mesh(triangle(size), kFace), std::invalid_argument) << size;
  }
}

}  // namespace
}  // namespace geodesic
