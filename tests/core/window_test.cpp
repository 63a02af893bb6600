// Compares the window kernel with elementary plane geometry.
#include "solvers/core/window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "solvers/core/window_predicates.h"

namespace geodesic {
namespace {

constexpr double kUnfoldedRounding = 1e-14;

Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// Fraction of the way from a to b at which the line through p and q meets it (Cramer's rule).
double meeting_point(const Point2& p, const Point2& q, const Point2& a, const Point2& b) {
  return cross(p - a, q - p) / cross(b - a, q - p);
}

struct Triangle2 {
  Point2 head, apex;  // the origin lies at (0, 0), the head on the x axis

  FaceFrame frame() const {
    const Mesh mesh(
        TriangleSoup{{{0, 0, 0}, {head.x, head.y, 0}, {apex.x, apex.y, 0}}, {{0, 1, 2}}});
    return face_frame(mesh, 0);
  }
};

const std::vector<Triangle2> kTriangles = {
    {{2, 0}, {1, 1.5}}, {{2, 0}, {-0.75, 1}}, {{2, 0}, {3.5, 0.5}}, {{1, 0}, {0.25, 1e-6}}};

const std::vector<Window> kWindows = {{.begin = 0.1, .end = 0.9, .x = 0.4, .y = -1, .sigma = 0},
                                      {.begin = 0, .end = 1, .x = -3, .y = -0.5, .sigma = 2},
                                      {.begin = 0.2, .end = 0.3, .x = 5, .y = -4, .sigma = 1}};

TEST(FaceFrame, holds_the_lengths_of_the_face) {
  for (const Triangle2& t : kTriangles) {
    const FaceFrame f = t.frame();
    EXPECT_NEAR(f.length, norm(t.head), kUnfoldedRounding);
    EXPECT_NEAR(f.left, norm(t.apex), kUnfoldedRounding);
    EXPECT_NEAR(f.right, norm(t.apex - t.head), kUnfoldedRounding);
    EXPECT_NEAR(f.apex_x, t.apex.x, kUnfoldedRounding);
    EXPECT_NEAR(f.apex_y, t.apex.y, kUnfoldedRounding);
  }
}

TEST(Unfolding, a_ray_meets_an_edge_where_two_lines_meet) {
  for (const Triangle2& t : kTriangles) {
    const FaceFrame f = t.frame();
    for (const Window& w : kWindows) {
      for (const double at : {w.begin, (w.begin + w.end) / 2, w.end}) {
        const Point2 source = {w.x, w.y}, through = {at, 0};
        const bool to_the_left = cross(through - source, t.apex - source) <= 0;
        const double on_left = meeting_point(source, through, {0, 0}, t.apex);
        const double on_right = meeting_point(source, through, t.apex, t.head);
        if (to_the_left) {
          EXPECT_NEAR(f.on_left(w, at), f.left * on_left, kUnfoldedRounding * f.left);
        } else {
          EXPECT_NEAR(f.on_right(w, at), f.right * on_right, kUnfoldedRounding * f.right);
        }
      }
    }
  }
}

TEST(Unfolding, a_ray_that_misses_an_edge_is_clamped_to_the_apex) {
  const FaceFrame f = kTriangles[0].frame();
  const Window w = kWindows[0];
  EXPECT_EQ(f.on_left({w.begin, w.end, -1, -1, 0}, 0.9), f.left) << "runs to the right edge";
  EXPECT_EQ(f.on_right({w.begin, w.end, 3, -1, 0}, 0.9), 0) << "runs to the left edge";
}

TEST(Unfolding, rays_through_the_ends_of_the_edge_meet_the_ends_of_the_edges_beyond) {
  const FaceFrame f = kTriangles[0].frame();
  const Window w = {.begin = 0, .end = f.length, .x = f.length / 2, .y = -2, .sigma = 0};
  EXPECT_EQ(f.on_left(w, 0), 0);
  EXPECT_EQ(f.on_right(w, f.length), f.right);
}

TEST(Unfolding, keeps_order_along_the_edges) {
  for (const Triangle2& t : kTriangles) {
    const FaceFrame f = t.frame();
    for (Window w : kWindows) {
      double before_left = 0, before_right = 0;
      for (int i = 0; i <= 100; ++i) {
        const double at = f.length * i / 100;
        EXPECT_GE(f.on_left(w, at), before_left);
        EXPECT_GE(f.on_right(w, at), before_right);
        before_left = f.on_left(w, at);
        before_right = f.on_right(w, at);
      }
    }
  }
}

TEST(Unfolding, moves_points_rigidly_with_the_edge_onto_the_x_axis) {
  for (const Triangle2& t : kTriangles) {
    const FaceFrame f = t.frame();
    const double size = f.length + f.left + f.right;
    EXPECT_NEAR(norm(f.to_left(0, 0)), 0, kUnfoldedRounding);
    EXPECT_NEAR(norm(f.to_left(t.apex.x, t.apex.y) - Point2{f.left, 0}), 0,
                kUnfoldedRounding * size);
    EXPECT_NEAR(norm(f.to_right(t.apex.x, t.apex.y)), 0, kUnfoldedRounding);
    EXPECT_NEAR(norm(f.to_right(t.head.x, t.head.y) - Point2{f.right, 0}), 0,
                kUnfoldedRounding * size);
    for (const Window& w : kWindows) {
      const Point2 source = {w.x, w.y};
      const Point2 left = f.to_left(w.x, w.y), right = f.to_right(w.x, w.y);
      EXPECT_NEAR(norm(left), norm(source), kUnfoldedRounding * 10);
      EXPECT_NEAR(norm(left - Point2{f.left, 0}), norm(source - t.apex), kUnfoldedRounding * 10);
      EXPECT_NEAR(norm(right), norm(source - t.apex), kUnfoldedRounding * 10);
      EXPECT_NEAR(norm(right - Point2{f.right, 0}), norm(source - t.head), kUnfoldedRounding * 10);
    }
  }
}

// A path keeps its length where it crosses a short side between two long ones.
TEST(Unfolding, over_a_short_side_of_a_needle_keeps_lengths) {
  for (double width = 1e-3; width > 1e-15; width /= 7) {
    const Vec3 tip = {-0.7, 0.9, 0.4}, end = {0, 0, 0};
    const Mesh mesh(TriangleSoup{{tip, end, {0.8 * width, 0.1 * width, 0.5 * width}}, {{0, 1, 2}}});
    for (Index h = 0; h < 3; ++h) {
      const FaceFrame f = face_frame(mesh, h);
      for (const Point2& along : {Point2{f.left_x, f.left_y}, Point2{f.right_x, f.right_y}}) {
        EXPECT_NEAR(norm(along), 1, 1e-15) << "side " << h << ", width " << width;
      }
    }
  }
}

TEST(Unfolding, leaves_the_face_below_the_edge_it_came_through) {
  for (const Triangle2& t : kTriangles) {
    const FaceFrame f = t.frame();
    EXPECT_LT(f.to_left(t.head.x, t.head.y).y, 0);
    EXPECT_LT(f.to_right(0, 0).y, 0);
  }
}

// All three vertices lie on a line. The face beyond is still unfolded correctly.
TEST(Unfolding, of_a_face_without_area_continues_straight) {
  const FaceFrame f = Triangle2{{2, 0}, {0.5, 0}}.frame();
  const Window w = {.begin = 0, .end = 2, .x = 1, .y = -1, .sigma = 0};
  EXPECT_EQ(f.apex_y, 0);
  EXPECT_NEAR(f.on_left(w, 0.25), 0.25, kUnfoldedRounding);
  EXPECT_NEAR(f.on_right(w, 1.25), 0.75, kUnfoldedRounding);
  EXPECT_EQ(f.on_left(w, 1.0), 0.5);
  EXPECT_EQ(f.on_right(w, 0.25), 0);
}

TEST(Unfolding, of_a_face_with_a_zero_length_edge_is_finite) {
  for (const Triangle2& t : {Triangle2{{1, 0}, {0, 0}}, Triangle2{{1, 0}, {1, 0}}}) {
    const FaceFrame f = t.frame();
    for (const Window& w : kWindows) {
      EXPECT_GE(f.on_left(w, 0.5), 0);
      EXPECT_LE(f.on_left(w, 0.5), f.left);
      EXPECT_GE(f.on_right(w, 0.5), 0);
      EXPECT_LE(f.on_right(w, 0.5), f.right);
      EXPECT_TRUE(std::isfinite(f.to_left(w.x, w.y).x));
      EXPECT_TRUE(std::isfinite(f.to_right(w.x, w.y).x));
    }
  }
}

TEST(Unfolding, from_a_source_on_the_edges_line_stays_within_the_edges) {
  const FaceFrame f = kTriangles[0].frame();
  for (const double x : {-1.0, 0.0, 2.0, 3.0}) {
    const Window w = {.begin = 0.5, .end = 1.5, .x = x, .y = 0, .sigma = 0};
    EXPECT_GE(f.on_left(w, 1), 0);
    EXPECT_LE(f.on_left(w, 1), f.left);
    EXPECT_GE(f.on_right(w, 1), 0);
    EXPECT_LE(f.on_right(w, 1), f.right);
  }
}

TEST(WindowSight, says_on_which_sides_of_a_point_lines_pass) {
  const Window w = {.begin = 0.5, .end = 1.5, .x = 1, .y = -1, .sigma = 0};
  const auto sides = [&](double x) {
    const WindowSight sight(w, {x, 1});
    return std::pair(sight.left(), sight.right());
  };
  EXPECT_EQ(sides(1), std::pair(true, true));
  EXPECT_EQ(sides(3), std::pair(true, false)) << "to the right of all lines";
  EXPECT_EQ(sides(-1), std::pair(false, true));
  EXPECT_TRUE(WindowSight(w, {1, 1}).reaches());
  EXPECT_FALSE(WindowSight(w, {3, 1}).reaches());
  EXPECT_FALSE(WindowSight(w, {-1, 1}).reaches());
}

TEST(WindowSight, reaches_what_its_last_line_misses_by_less_than_the_tolerance) {
  const Window w = {.begin = 0.5, .end = 1.5, .x = 1, .y = -1, .sigma = 0};
  // The lines through the ends pass (0, 1) and (2, 1), which lie at a distance of sqrt(5) from the
  // source. An end is half as far off the line to a point as that point is beside them, times the
  // cosine of atan(1/2), 2 / sqrt(5).
  for (const double off : {0.5, 2.0}) {
    const double beside = off * kApexReach * 5;
    EXPECT_EQ(WindowSight(w, {2 + beside, 1}).reaches(), off < 1);
    EXPECT_EQ(WindowSight(w, {2 + beside, 1}).at_end(), off < 1);
    EXPECT_EQ(WindowSight(w, {-beside, 1}).reaches(), off < 1);
    EXPECT_EQ(WindowSight(w, {-beside, 1}).at_begin(), off < 1);
  }
}

TEST(SidesNotCrossing, are_those_of_lines_that_begin_and_pass_on_one_side_of_the_path) {
  constexpr Sides kLeft{true, false}, kRight{false, true}, kBoth{true, true}, kNone{false, false};
  EXPECT_EQ(sides_not_crossing(kBoth, 0.1, 0.4, 0.5), kLeft);
  EXPECT_EQ(sides_not_crossing(kBoth, 0.6, 0.9, 0.5), kRight);
  EXPECT_EQ(sides_not_crossing(kBoth, 0.4, 0.6, 0.5), kBoth) << "the path crosses the interval";
  EXPECT_EQ(sides_not_crossing(kRight, 0.1, 0.4, 0.5), kNone);
  EXPECT_EQ(sides_not_crossing(kLeft, 0.6, 0.9, 0.5), kNone);
  EXPECT_EQ(sides_not_crossing(kLeft, 0.1, 0.4, 0.5), kLeft);
}

TEST(WindowDistance, is_that_of_the_source_plus_sigma) {
  const Window w = {.begin = 1, .end = 2, .x = 4, .y = -4, .sigma = 10};
  EXPECT_EQ(distance_at(w, 1), 15);
  EXPECT_EQ(distance_through(w, 1, 0), 15);
  EXPECT_EQ(distance_through(w, 4, 2), 16);
}

TEST(WindowDistance, is_least_at_the_foot_of_the_perpendicular_or_the_nearer_end) {
  EXPECT_EQ(nearest_position({1, 3, 2, -1, 0}), 2);
  EXPECT_EQ(nearest_position({1, 3, 0, -1, 0}), 1);
  EXPECT_EQ(nearest_position({1, 3, 9, -1, 0}), 3);
  EXPECT_EQ(least_distance({1, 3, 2, -1, 0.5}), 1.5);
  EXPECT_EQ(least_distance({1, 3, 6, -4, 0.5}), 5.5);
}

// Compares with the shortest of many sampled paths with two legs.
TEST(WindowDistance, beyond_the_edge_is_straight_or_bent_at_an_end) {
  for (const Window& w : kWindows) {
    for (const Point2 target : {Point2{0.5, 1}, Point2{-4, 0.5}, Point2{6, 2}, Point2{0.1, 0}}) {
      double sampled = kInfinity;
      for (int i = 0; i <= 10000; ++i) {
        const double t = w.begin + (w.end - w.begin) * i / 10000;
        sampled = std::min(sampled, distance_at(w, t) + norm(target - Point2{t, 0}));
      }
      const double least = least_distance_to(w, target.x, target.y);
      EXPECT_LE(least, sampled + kUnfoldedRounding);
      EXPECT_NEAR(least, sampled, 1e-7);
    }
  }
}

TEST(WindowDistance, along_the_edges_line_needs_no_crossing) {
  const Window w = {.begin = 1, .end = 2, .x = 0, .y = 0, .sigma = 1};
  EXPECT_EQ(least_distance_to(w, 3, 0), 4);
  EXPECT_EQ(least_distance_to(w, 1.5, 0), 2.5);
}

}  // namespace
}  // namespace geodesic
