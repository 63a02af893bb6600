// Compares a merged window with the two windows that it replaces, as merge.h promises, in the plane
// of the edge and of the face beyond it.
#include "solvers/edge_based/merge.h"

#include <gtest/gtest.h>

#include <vector>

#include "meshes/random.h"

namespace geodesic::edge_based {
namespace {

constexpr double kOff = 1e-12;  // error by rounding

struct Neighbours {
  MergedWindow first, second;
};

/// Neighbours whose intervals meet or overlap. Their sources are close together, as after passing a
/// vertex on both sides; some have different pseudo-sources.
Neighbours random_neighbours(Random& random) {
  const double begin = random.between(0, 0.3), tie = random.between(0.4, 0.6);
  const double end = random.between(0.7, 1), overlap = random.below(2) * random.between(0, 0.05);
  const double x = random.between(-2, 3), y = random.between(-3, -0.1);
  const double apart = std::pow(10, random.between(-4, -0.5));
  Window a{begin, tie + overlap, x, y, random.between(0, 2)};
  Window b{tie - overlap, end, x + apart * random.between(-1, 1),
           std::min(y + apart * random.between(-1, 1), -0.05), 0};
  b.sigma = distance_at(a, tie) - distance_at({0, 0, b.x, b.y, 0}, tie);
  return {{a, static_cast<float>(random.between(0, 0.001))},
          {b, static_cast<float>(random.between(0, 0.001))}};
}

template <class Check>
void for_each_merged(double tolerance, int least, const Check& check) {
  Random random(1);
  int merged = 0;
  for (int i = 0; i < 20000; ++i) {
    const Neighbours pair = random_neighbours(random);
    MergedWindow m = pair.first, second = pair.second;
    if (join(m, second, 1, 0, {tolerance, 1}) != Joined::merged) continue;
    ++merged;
    check(pair, m);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(merged, least);
}

TEST(Merge, keeps_the_distances_of_both_ends) {
  for_each_merged(0.1, 5000, [](const Neighbours& pair, const MergedWindow& m) {
    const Window &a = pair.first.window, &b = pair.second.window;
    EXPECT_EQ(m.window.begin, a.begin);
    EXPECT_EQ(m.window.end, b.end);
    EXPECT_NEAR(distance_at(m.window, a.begin), distance_at(a, a.begin), kOff);
    EXPECT_NEAR(distance_at(m.window, b.end), distance_at(b, b.end), kOff);
  });
}

TEST(Merge, makes_no_distance_longer_in_the_face_or_on_the_edge) {
  Random random(2);
  for_each_merged(0.1, 5000, [&](const Neighbours& pair, const MergedWindow& m) {
    for (const MergedWindow& of : {pair.first, pair.second}) {
      const Window& w = of.window;
      for (int k = 0; k <= 16; ++k) {
        // (x, y) lies on a line of the window, on the edge or in the face.
        const double t = w.begin + (w.end - w.begin) * k / 16;
        const double beyond = k % 2 == 0 ? 0 : random.between(0, 1);
        const double x = t + (t - w.x) * beyond, y = -w.y * beyond;
        EXPECT_LE(least_distance_to(m.window, x, y) - distance_through(w, x, y), kOff);
      }
    }
  });
}

TEST(Merge, makes_no_distance_shorter_than_the_shortfall_says) {
  for_each_merged(0.1, 5000, [](const Neighbours& pair, const MergedWindow& m) {
    const Window &a = pair.first.window, &b = pair.second.window;
    for (int k = 0; k <= 64; ++k) {
      const double t = a.begin + (b.end - a.begin) * k / 64;
      double most = kInfinity;  // upper bound of the true distance
      if (t <= a.end) most = std::min(most, distance_at(a, t) + double{pair.first.shortfall});
      if (t >= b.begin) most = std::min(most, distance_at(b, t) + double{pair.second.shortfall});
      EXPECT_GE(distance_at(m.window, t) + double{m.shortfall}, most - kOff);
    }
  });
}

TEST(Merge, keeps_the_shortfall_below_the_tolerance) {
  for (const double tolerance : {0.3, 0.01, 0.001}) {
    for_each_merged(tolerance, 1000, [&](const Neighbours&, const MergedWindow& m) {
      EXPECT_LE(double{m.shortfall}, tolerance * least_distance(m.window) * (1 + 1e-6));
    });
  }
}

TEST(Join, changes_no_least_distance_of_the_edge_where_it_does_not_merge) {
  Random random(3);
  int shortened = 0;
  for (int i = 0; i < 20000; ++i) {
    const Neighbours pair = random_neighbours(random);
    MergedWindow first = pair.first, second = pair.second;
    const Joined joined = join(first, second, 1, 0, {0, 0});
    ASSERT_NE(joined, Joined::merged);
    const auto least = [](const MergedWindow& a, bool has_a, const MergedWindow& b, bool has_b,
                          double t) {
      const auto at = [&](const Window& w) {
        return t < w.begin || t > w.end ? kInfinity : distance_at(w, t);
      };
      return std::min(has_a ? at(a.window) : kInfinity, has_b ? at(b.window) : kInfinity);
    };
    shortened += first.window.end != pair.first.window.end ||
                 second.window.begin != pair.second.window.begin;
    for (int k = 0; k <= 64; ++k) {
      const double t = pair.first.window.begin +
                       (pair.second.window.end - pair.first.window.begin) * (k + 0.5) / 65;
      const double before = least(pair.first, true, pair.second, true, t);
      const double after =
          least(first, joined != Joined::first_gone, second, joined != Joined::second_gone, t);
      ASSERT_NEAR(after, before, kOff) << i << ", " << t;
    }
  }
  EXPECT_GT(shortened, 1000);
}

TEST(Join, of_two_parts_of_one_window_is_that_window) {
  const Window whole{0.1, 0.9, 0.4, -1.5, 2};
  MergedWindow m{{0.1, 0.5, 0.4, -1.5, 2}, 0}, second{{0.5, 0.9, 0.4, -1.5, 2}, 0};
  ASSERT_EQ(join(m, second, 1, 0, {1e-9, 1}), Joined::merged);
  for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    EXPECT_NEAR(distance_at(m.window, t), distance_at(whole, t), kOff);
  }
  EXPECT_LE(double{m.shortfall}, kOff);
}

TEST(Join, leaves_windows_alone_that_are_apart_or_of_a_source_on_the_edge) {
  for (const Window& w : {Window{0.6, 0.9, 0.4, -1.5, 2}, Window{0.5, 0.9, 0.4, 0, 2}}) {
    MergedWindow first{{0.1, 0.5, 0.4, -1.5, 2}, 0}, second{w, 0};
    EXPECT_EQ(join(first, second, 1, 0, {1, 1}), Joined::neither);
    EXPECT_EQ(first.window.end, 0.5);
  }
}

}  // namespace
}  // namespace geodesic::edge_based
