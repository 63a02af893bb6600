// Laying windows over an edge: the list stays a partition and becomes the lower envelope.
#include "solvers/mmp/overlay.h"

#include <gtest/gtest.h>

#include <random>

#include "solvers/core/recorders.h"

namespace geodesic::mmp {
namespace {

using W = EdgeWindow<NoDepth>;
static_assert(sizeof(W) == 32, "a stored window is two to a cache line");

/// The windows of one edge, for overlays without a solver.
class EdgeList {
 public:
  explicit EdgeList(double length) : length_(length), windows_{W::gap(0)} {}

  bool lay(const Window& w) {
    const Index source = static_cast<Index>(sigmas_.size());
    sigmas_.push_back(w.sigma);
    Overlay<W> result;
    if (!overlay(std::span<const W>(windows_), length_, W{w.begin, w.x, w.y, source, kNone, {}},
                 w.end, std::span<const double>(sigmas_), result)) {
      return false;
    }
    std::vector<W> next(windows_.begin(), windows_.begin() + std::ptrdiff_t(result.first));
    for (const W& piece : result.pieces()) next.push_back(piece);
    next.insert(next.end(), windows_.begin() + std::ptrdiff_t(result.last), windows_.end());
    windows_ = std::move(next);
    replaced_ = result.last - result.first;
    return true;
  }

  double distance(double t) const {
    const std::span<const W> list(windows_);
    const W& w = list[window_at(list, t)];
    return w.is_gap() ? kInfinity : distance_at(w.geometry(0, sigma(w)), t);
  }

  double sigma(const W& w) const { return sigmas_[w.source]; }
  std::size_t replaced() const { return replaced_; }
  const std::vector<W>& windows() const { return windows_; }

 private:
  double length_;
  std::vector<W> windows_;
  std::vector<double> sigmas_;  // by source number
  std::size_t replaced_ = 0;    // number of windows, by the latest overlay
};

TEST(Overlay, BecomesTheLowerEnvelopeWhateverTheOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Window> all;
    EdgeList list(1);
    for (int k = 0; k < 12; ++k) {
      const double a = uniform(random), b = uniform(random);
      all.push_back({std::min(a, b), std::max(a, b), 2 * uniform(random) - 0.5,
                     2 * uniform(random) - 1, 0.5 * uniform(random)});
      list.lay(all.back());
    }
    for (int i = 0; i < 500; ++i) {
      const double t = uniform(random);
      double least = kInfinity;
      for (const Window& w : all) {
        if (w.begin <= t && t <= w.end) least = std::min(least, distance_at(w, t));
      }
      if (least == kInfinity) {
        EXPECT_EQ(list.distance(t), kInfinity) << "nothing reaches " << t;
      } else {
        EXPECT_NEAR(list.distance(t), least, 1e-12) << "round " << round << ", position " << t;
      }
    }
    for (std::size_t i = 1; i < list.windows().size(); ++i) {
      EXPECT_LT(list.windows()[i - 1].begin, list.windows()[i].begin);
    }
  }
}

TEST(Overlay, RefusesAWindowThatIsThereAlready) {
  EdgeList list(1);
  const Window w{0.25, 0.75, 0.4, -1, 2};
  EXPECT_TRUE(list.lay(w));
  EXPECT_FALSE(list.lay(w));
  EXPECT_EQ(list.windows().size(), 3u) << "gap, window, gap";
}

TEST(Overlay, LeavesAloneWhatLiesAroundThePartsThatAreWon) {
  EdgeList list(1);
  for (int k = 0; k < 8; ++k) list.lay({k / 8.0, (k + 1) / 8.0, (k + 0.5) / 8, -1, 1});
  // The new window covers the edge but is nearer only within the fourth window.
  EXPECT_TRUE(list.lay({0, 1, 3.5 / 8, -0.001, 1.99}));
  EXPECT_EQ(list.replaced(), 1u);
  EXPECT_EQ(list.windows().size(), 10u);
}

TEST(Overlay, MakesNoPieceNarrowerThanTheTolerance) {
  EdgeList list(1);
  list.lay({0, 0.5, 0.2, -1, 0});
  list.lay({0.5 - 1e-16, 1, 0.2, -1, 0.5});   // overlaps by rounding
  list.lay({0.5 + 1e-16, 1, 0.2, -1, 0.25});  // leaves a gap by rounding
  ASSERT_EQ(list.windows().size(), 2u);
  EXPECT_EQ(list.windows()[1].begin, 0.5);
  EXPECT_EQ(list.sigma(list.windows()[1]), 0.25);
}

}  // namespace
}  // namespace geodesic::mmp
