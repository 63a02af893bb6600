// Windows laid over one edge: its list stays a partition and becomes the lower envelope.
#include <gtest/gtest.h>

#include <random>

#include "solvers/core/queues/calendar_queue.h"
#include "solvers/mmp/windows_of_edges.h"

namespace geodesic::mmp {
namespace {

/// The windows of one edge, without a solver.
class Edge {
 public:
  explicit Edge(double length) : length_(length) {}

  /// @return the edge's windows afterwards
  const std::vector<Window>& lay(const Window& w) {
    edges_.insert(0, length_, {w, kNone, State::waits, {}});
    edges_.copy_windows(0, windows_);
    return windows_;
  }

  /// Infinite where there is no window.
  double distance(double t) const {
    for (const Window& w : windows_) {
      if (w.begin <= t && t < w.end) return distance_at(w, t);
    }
    return kInfinity;
  }

  const std::vector<Window>& windows() const { return windows_; }

 private:
  using Queue = CalendarQueue<Index>;

  double length_;
  NoRecorder recorder_;
  WindowsOfEdges<Queue, NoRecorder> edges_{1, Queue({.width = 1, .count = 8}), recorder_};
  std::vector<Window> windows_;
};

void expect_to_be_the_lower_envelope(const Edge& edge, const std::vector<Window>& all) {
  for (int i = 0; i < 500; ++i) {
    const double t = (i + 0.123) / 500;
    double least = kInfinity;
    for (const Window& w : all) {
      if (w.begin <= t && t <= w.end) least = std::min(least, distance_at(w, t));
    }
    if (least == kInfinity) {
      EXPECT_EQ(edge.distance(t), kInfinity) << "nothing reaches " << t;
    } else {
      EXPECT_NEAR(edge.distance(t), least, 1e-12) << "at " << t;
    }
  }
  for (std::size_t i = 0; i < edge.windows().size(); ++i) {
    EXPECT_LT(edge.windows()[i].begin, edge.windows()[i].end);
    if (i > 0) {
      EXPECT_LE(edge.windows()[i - 1].end, edge.windows()[i].begin);
    }
  }
}

TEST(Insertion, makes_the_lower_envelope_whatever_the_order) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    std::vector<Window> all;
    Edge edge(1);
    for (int k = 0; k < 12; ++k) {
      const double a = uniform(random), b = uniform(random);
      all.push_back({std::min(a, b), std::max(a, b), 2 * uniform(random) - 0.5,
                     2 * uniform(random) - 1, 0.5 * uniform(random)});
      edge.lay(all.back());
    }
    expect_to_be_the_lower_envelope(edge, all);
  }
}

TEST(Insertion, gives_a_window_the_parts_on_both_sides_of_another_one) {
  const Window near{0, 1, 0.5, -0.1, 2.85}, far{0, 1, 0.5, -3, 0};
  for (const auto& [before, after] : {std::pair{1.0, 1.0}, {0.5, 0.5}, {0.3, 0.2}}) {
    // The near window is alone, or has neighbours that lose everything.
    std::vector<Window> all = {near};
    all[0].begin = 0.5 - 0.5 * before;
    all[0].end = 0.5 + 0.5 * after;
    all.push_back({0, all[0].begin, 0.5, -4, 3});
    all.push_back({all[0].end, 1, 0.5, -4, 3});
    Edge edge(1);
    for (const Window& w : all) {
      if (w.end > w.begin) edge.lay(w);
    }
    all.push_back(far);
    ASSERT_EQ(edge.lay(far).size(), 3u);
    EXPECT_EQ(edge.windows()[0].sigma, far.sigma);
    EXPECT_EQ(edge.windows()[1].sigma, near.sigma);
    EXPECT_EQ(edge.windows()[2].sigma, far.sigma);
    expect_to_be_the_lower_envelope(edge, all);
  }
}

TEST(Insertion, refuses_a_window_that_is_there_already) {
  Edge edge(1);
  const Window w{0.25, 0.75, 0.4, -1, 2};
  EXPECT_EQ(edge.lay(w).size(), 1u);
  EXPECT_EQ(edge.lay(w).size(), 1u);
}

TEST(Insertion, leaves_alone_what_lies_around_the_parts_that_are_won) {
  Edge edge(1);
  for (int k = 0; k < 8; ++k) edge.lay({k / 8.0, (k + 1) / 8.0, (k + 0.5) / 8, -1, 1});
  const std::vector<Window> before = edge.windows();
  // The new window covers the edge but is nearer only within the fourth window.
  const std::vector<Window>& after = edge.lay({0, 1, 3.5 / 8, -0.001, 1.99});
  ASSERT_EQ(after.size(), 10u);
  for (std::size_t k = 0; k < 8; ++k) {
    if (k == 3) continue;
    EXPECT_EQ(after[k < 3 ? k : k + 2].begin, before[k].begin);
    EXPECT_EQ(after[k < 3 ? k : k + 2].end, before[k].end);
  }
}

TEST(Insertion, makes_no_piece_narrower_than_the_tolerance) {
  Edge edge(1);
  edge.lay({0, 0.5, 0.2, -1, 0});
  edge.lay({0.5 - 1e-16, 1, 0.2, -1, 0.5});   // overlaps by rounding
  edge.lay({0.5 + 1e-16, 1, 0.2, -1, 0.25});  // leaves a gap by rounding
  ASSERT_EQ(edge.windows().size(), 2u);
  EXPECT_EQ(edge.windows()[1].begin, 0.5);
  EXPECT_EQ(edge.windows()[1].sigma, 0.25);
}

TEST(Insertion, finds_its_place_in_a_long_list_and_makes_room_at_either_end) {
  for (const bool forward : {true, false}) {
    constexpr int kWindows = 1000;
    std::vector<Window> all;
    Edge edge(1);
    const auto add = [&](double begin, double width, double sigma) {
      all.push_back({begin, begin + width, begin + width / 2, -1, sigma});
      edge.lay(all.back());
    };
    for (int k = 0; k < kWindows; ++k) {
      add((forward ? k : kWindows - 1 - k) / double{kWindows}, 1.0 / kWindows, 1);
    }
    for (int k = 0; k < kWindows; k += 7) add((k + 0.25) / kWindows, 0.5 / kWindows, 0.5);
    expect_to_be_the_lower_envelope(edge, all);
  }
}

}  // namespace
}  // namespace geodesic::mmp
