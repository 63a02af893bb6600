// Strategies I and II, checked against the argument behind them: a line may be dropped only if it
// meets a shorter path of the other window before it reaches the edge from which it is dropped.
#include <gtest/gtest.h>

#include <cmath>

#include "solvers/edge_based/trim.h"
#include "tests/edge_based/steps.h"

namespace geodesic::edge_based {
namespace {

constexpr int kPositions = 33;  // number of intervals between tested positions
constexpr double kRounding = 1e-12;

/// The face below reaches below all sources, so that everything lies in one plane.
constexpr EdgeBelow kBelow{.length = 1, .below_x = 0.5, .below_y = -1e4};

/// @param k 0 to kPositions
double position(double from, double to, int k) { return from + (to - from) * k / kPositions; }

bool holds(const Window& w, double t) { return w.begin <= t && t <= w.end; }

Window random_window(Random& random) {
  const double a = random.between(0, 1), b = random.between(0, 1);
  return {std::min(a, b), std::max(a, b), random.between(-0.5, 1.5), random.between(-2, -0.05),
          random.between(0, 0.5)};
}

/// The line leaves `w` through position t. Returns the minimum of (length of a path by `rival`) -
/// (length of the line) over the points of the line that `rival` sees. The difference is convex
/// along the line, and these points form an interval. Returns infinity if `rival` sees no point.
/// @param beyond length of the line, in units of its length from the source to the edge
double lead_of(const Window& w, double t, double beyond, const Window& rival) {
  double from = 0, to = beyond;
  const auto at = [&](double s) { return Point2{w.x + s * (t - w.x), w.y - s * w.y}; };
  const auto keep_where = [&](auto&& value) {  // keeps the s with value >= 0; value is linear in s
    const double first = value(at(0)), slope = value(at(1)) - first;
    if (slope > 0) from = std::max(from, -first / slope);
    if (slope < 0) to = std::min(to, -first / slope);
    if (slope == 0 && first < 0) to = -1;
  };
  keep_where([&](const Point2& p) { return right_of(rival, rival.begin, p.x, p.y); });
  keep_where([&](const Point2& p) { return -right_of(rival, rival.end, p.x, p.y); });
  keep_where([&](const Point2& p) { return p.y - rival.y; });
  if (!(from <= to)) return kInfinity;
  const auto lead = [&](double s) {
    const Point2 p = at(s);
    return distance_through(rival, p.x, p.y) - distance_through(w, p.x, p.y);
  };
  for (int i = 0; i < 60; ++i) {
    const double a = from + (to - from) / 3, b = to - (to - from) / 3;
    (lead(a) < lead(b) ? to : from) = lead(a) < lead(b) ? b : a;
  }
  return lead(0.5 * (from + to));
}

TEST(TrimPair, removes_only_lines_that_a_path_of_the_other_window_beats_before_the_edge) {
  Random random(1);
  int removed = 0;
  for (int pair = 0; pair < 4000; ++pair) {
    const Window windows[] = {random_window(random), random_window(random)};
    Window left[] = {windows[0], windows[1]};
    trim_pair(left[0], left[1], kBelow);
    for (const int i : {0, 1}) {
      ASSERT_LE(windows[i].begin, left[i].begin);
      ASSERT_GE(windows[i].end, left[i].end);
      for (int k = 1; k < kPositions; ++k) {
        const double t = position(windows[i].begin, windows[i].end, k);
        if (!is_void(left[i], 1) && holds(left[i], t)) continue;
        ++removed;
        ASSERT_LE(lead_of(windows[i], t, 1, windows[1 - i]), kRounding)
            << "pair " << pair << ", window " << i << ", line through " << t;
      }
    }
  }
  EXPECT_GT(removed, 4000);
}

TEST(TrimPair, keeps_the_least_distance_of_every_position_that_both_windows_cover) {
  Random random(2);
  for (int pair = 0; pair < 4000; ++pair) {
    const Window a = random_window(random), b = random_window(random);
    Window first = a, second = b;
    trim_pair(first, second, kBelow);
    const double from = std::max(a.begin, b.begin), to = std::min(a.end, b.end);
    for (int k = 1; from < to && k < kPositions; ++k) {
      const double t = position(from, to, k);
      double left = kInfinity;
      if (holds(first, t)) left = distance_at(first, t);
      if (holds(second, t)) left = std::min(left, distance_at(second, t));
      ASSERT_LE(left, std::min(distance_at(a, t), distance_at(b, t)) + kRounding)
          << "pair " << pair << " at " << t;
    }
  }
}

TEST(TrimPair, removes_a_window_that_is_behind_everywhere) {
  Window first{0.1, 0.9, 0.5, -1, 0}, second{0.2, 0.8, 0.6, -1, 5};
  trim_pair(first, second, kBelow);
  EXPECT_TRUE(is_void(second, 1));
  EXPECT_EQ(first.begin, 0.1);
  EXPECT_EQ(first.end, 0.9);
}

TEST(TrimPair, does_not_depend_on_the_order_of_the_windows) {
  Random random(3);
  for (int pair = 0; pair < 4000; ++pair) {
    const Window a = random_window(random), b = random_window(random);
    Window first = a, second = b, other_first = b, other_second = a;
    trim_pair(first, second, kBelow);
    trim_pair(other_first, other_second, kBelow);
    ASSERT_NEAR(first.begin, other_second.begin, kRounding) << pair;
    ASSERT_NEAR(first.end, other_second.end, kRounding) << pair;
    ASSERT_NEAR(second.begin, other_first.begin, kRounding) << pair;
    ASSERT_NEAR(second.end, other_first.end, kRounding) << pair;
  }
}

TEST(TrimPair, leaves_windows_of_one_source_alone) {
  Random random(4);
  for (int pair = 0; pair < 2500; ++pair) {
    const Window a = random_window(random);
    Window b = random_window(random);
    b = {b.begin, b.end, a.x, a.y, a.sigma};
    Window first = a, second = b;
    trim_pair(first, second, kBelow);
    EXPECT_EQ(first.begin, a.begin);
    EXPECT_EQ(first.end, a.end);
    EXPECT_EQ(second.begin, b.begin);
    EXPECT_EQ(second.end, b.end);
  }
}

Sides sides_seen(const Window& w, const FaceFrame& face) {
  const double t = w.x + (face.apex_x - w.x) * (-w.y / (face.apex_y - w.y));
  return {t >= w.begin, t <= w.end};
}

constexpr Sides kBoth{true, true};

/// Length of the line through t up to where it leaves the face, in units of its length to the edge.
double to_far_edge(const Window& w, double t, const FaceFrame& f) {
  const bool left = right_of(w, t, f.apex_x, f.apex_y) > 0;
  const double on = left ? f.on_left(w, t) : f.on_right(w, t);
  const double y = left ? on * f.left_y : f.apex_y + on * f.right_y;
  return 1 + y / -w.y;
}

// Windows from a lattice of 708 x 708 vertices. Their common source is vertex 0, 1,500 faces away.
TEST(TrimPair, leaves_windows_alone_that_see_one_source_in_two_places) {
  const Window left{0.75000000000077727, 0.75968992248147016, -652.99999999997499,
                    -504.99999999997772, 0};
  const Window right{0.75968992248147016, 0.76753507014032751, -652.9999999999684,
                     -504.99999999997249, 0};
  Window first = left, second = right;
  trim_pair(first, second, {.length = 1, .below_x = 0, .below_y = -1, .rounding = 1.4e-14});
  EXPECT_EQ(first.begin, left.begin);
  EXPECT_EQ(first.end, left.end);
  EXPECT_EQ(second.begin, right.begin);
  EXPECT_EQ(second.end, right.end);
}

TEST(SidesKept, takes_only_lines_that_the_path_to_the_apex_beats_inside_the_face) {
  Random random(5);
  int removed = 0;
  for (int pair = 0; pair < 4000; ++pair) {
    const FaceFrame face = random_face(random);
    const Window best = random_window(random), w = random_window(random);
    const Sides seen = sides_seen(w, face);
    if (sides_seen(best, face) != kBoth) continue;
    const ApexWinner winner{.window = 0,
                            .distance = distance_through(best, face.apex_x, face.apex_y),
                            .position = apex_line_in(best, face)};
    if (seen == kBoth && distance_through(w, face.apex_x, face.apex_y) < winner.distance) {
      continue;  // w itself gives the separating path
    }
    const Sides kept = sides_kept(w, seen, winner, best, face, 0);
    for (int k = 1; k < kPositions; ++k) {
      const double t = position(w.begin, w.end, k);
      if (right_of(w, t, face.apex_x, face.apex_y) > 0 ? kept.left : kept.right) continue;
      ++removed;
      ASSERT_LE(lead_of(w, t, to_far_edge(w, t, face), best), kRounding)
          << "pair " << pair << ", line through " << t;
    }
  }
  EXPECT_GT(removed, 2000);
}

TEST(SidesKept, keeps_both_sides_of_a_tie) {
  const FaceFrame face = face_of({0.5, 0.5});
  const Window left{0, 0.5, 0.25, -1, 0}, right{0.5, 1, 0.75, -1, 0};
  const ApexWinner winner{.window = 0,
                          .distance = distance_through(left, face.apex_x, face.apex_y),
                          .position = apex_line_in(left, face)};
  EXPECT_EQ(sides_kept(right, kBoth, winner, left, face, 0), kBoth);
}

}  // namespace
}  // namespace geodesic::edge_based
