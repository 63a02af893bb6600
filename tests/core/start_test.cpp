// What propagation begins with: the sources as vertices and windows.
#include "solvers/core/start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

// Two faces: the square with corners (0, 0), (2, 0), (2, 2), (0, 2), and its diagonal from 0 to 2.
const Mesh plate(TriangleSoup{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                              {{0, 1, 2}, {0, 2, 3}}});

Start from(const SurfacePoint& point) {
  return Start(plate,
               in_internal_numbers(plate, {.sources = {{SurfacePoint(0), 0.5}, {point, 0.25}}}));
}

TEST(Start, at_a_vertex_is_this_vertex_and_emits) {
  const Start start = from(SurfacePoint(3));
  ASSERT_EQ(start.vertices.size(), 2u);
  EXPECT_TRUE(start.windows.empty());
  EXPECT_EQ(start.vertices[1].vertex, 3u);
  EXPECT_EQ(start.vertices[1].distance, 0.25);
  EXPECT_TRUE(start.vertices[1].always_emits);
  EXPECT_EQ(start.vertices[1].last_segment, (LastSegment{kNone, 3, {0, 0}}));
}

TEST(Start, in_a_face_is_at_its_corners_and_passes_its_sides) {
  const Start start = from(point_in_face(plate, 0, {0.5, 0.25, 0.25}));  // (1, 0.5)
  ASSERT_EQ(start.vertices.size(), 4u);
  for (const StartVertex& each : std::span(start.vertices).subspan(1)) {
    const Vec3 to = plate.position(each.vertex);
    EXPECT_NEAR(each.distance, 0.25 + std::hypot(to[0] - 1, to[1] - 0.5), 1e-15);
    EXPECT_FALSE(each.always_emits);
    EXPECT_EQ(each.last_segment.root, 5u) << "the second source of four vertices";
    EXPECT_EQ(plate.apex(each.last_segment.half_edge), each.vertex);
  }
  ASSERT_EQ(start.windows.size(), 3u);
  for (const StartWindow& each : start.windows) {
    EXPECT_EQ(each.side / 3, 0u);
    EXPECT_EQ(each.window.begin, 0);
    EXPECT_EQ(each.window.end, plate.half_edge(each.side).length);
    EXPECT_LT(each.window.y, 0);
    EXPECT_EQ(each.window.sigma, 0.25);
    EXPECT_EQ(each.root, 5u);
  }
}

TEST(Start, on_an_edge_passes_the_other_sides_of_both_faces) {
  const Start start = from(point_in_face(plate, 0, {0.5, 0, 0.5}));  // (1, 1)
  EXPECT_EQ(start.vertices.size(), 7u) << "corners of both faces";
  ASSERT_EQ(start.windows.size(), 4u);
  for (const StartWindow& each : start.windows) EXPECT_EQ(plate.twin(each.side), kNone);
}

TEST(Start, next_to_a_corner_lets_the_corner_emit_and_nearer_than_rounding_it_alone) {
  const auto emitting = [](const Start& start) {
    return std::ranges::count(start.vertices, true, &StartVertex::always_emits) - 1;
  };
  const double near = kCoordinateRounding;
  EXPECT_EQ(emitting(from(point_in_face(plate, 0, {0.5, 0.25, 0.25}))), 0);
  const Start next = from(point_in_face(plate, 0, {1 - 4 * near, 2 * near, 2 * near}));
  EXPECT_EQ(emitting(next), 1);
  EXPECT_EQ(next.windows.size(), 3u);
  const Start at = from(point_in_face(plate, 0, {1 - near / 4, near / 8, near / 8}));
  EXPECT_EQ(emitting(at), 1);
  EXPECT_TRUE(at.windows.empty());
}

}  // namespace
}  // namespace geodesic
