// Division of an interval between two windows, compared with sampling, and degenerate cases.
#include "solvers/mmp/intersect.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace geodesic::mmp {
namespace {

constexpr double kNarrowest = 1e-14;

Window from_source(double x, double y, double sigma) { return {0, 1, x, y, sigma}; }

bool challenger_owns(const Division& division, double t) {
  bool owns = division.challenger_first;
  for (int k = 0; k < division.cuts && division.at[k] <= t; ++k) owns = !owns;
  return owns;
}

/// The largest excess of the owner's distance over the smaller distance, at sampled positions.
double worst_choice(const Window& challenger, const Window& incumbent, double from, double to) {
  const Division division = divide(challenger, incumbent, from, to, kNarrowest);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = from + (to - from) * i / 1000;
    const double c = distance_at(challenger, t), d = distance_at(incumbent, t);
    worst = std::max(worst, (challenger_owns(division, t) ? c : d) - std::min(c, d));
  }
  return worst;
}

TEST(Divide, GivesEveryPointToTheNearerOfTwoRandomWindows) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 3000; ++i) {
    // The sources are 1e-3 to 10 away. The sigmas differ by similar amounts.
    const double reach = std::pow(10.0, 2 * uniform(random) - 1);
    const Window a =
        from_source(reach * uniform(random), reach * uniform(random), 2 + uniform(random));
    const Window b =
        from_source(reach * uniform(random), reach * uniform(random), 2 + reach * uniform(random));
    EXPECT_LE(worst_choice(a, b, 0, 1), 1e-13) << "case " << i;
  }
}

TEST(Divide, CutsTwiceAroundANearSourceThatIsBehind) {
  const Window far = from_source(0.5, -3, 0), near = from_source(0.5, -0.1, 2.85);
  const Division division = divide(near, far, 0, 1, kNarrowest);
  EXPECT_FALSE(division.challenger_first);
  ASSERT_EQ(division.cuts, 2);
  EXPECT_NEAR(division.at[0] + division.at[1], 1, 1e-14) << "symmetric about x = 0.5";
  EXPECT_LE(worst_choice(near, far, 0, 1), 1e-15);
  EXPECT_LE(worst_choice(far, near, 0, 1), 1e-15);
}

TEST(Divide, LeavesTiesToTheIncumbent) {
  const Window w = from_source(0.3, -0.7, 1);
  const Window mirrored = from_source(0.3, 0.7, 1);  // the same distances from the other face
  for (const Window& challenger : {w, mirrored}) {
    const Division division = divide(challenger, w, 0, 1, kNarrowest);
    EXPECT_FALSE(division.challenger_first);
    EXPECT_EQ(division.cuts, 0);
  }
}

TEST(Divide, GivesAllToTheShorterWindowWhereRoundingHidesItsLeadAtTheFarEnd) {
  const double length = 370361;
  const Window shorter{0, length, length, 0.3, 1.5};
  Window longer = shorter;
  longer.sigma += 1.7e-9;  // below kPathMargin of the distances beyond a half of the edge
  const Division won = divide(shorter, longer, 0, length, 1e-14 * length);
  EXPECT_TRUE(won.challenger_first);
  EXPECT_EQ(won.cuts, 0);
  const Division lost = divide(longer, shorter, 0, length, 1e-14 * length);
  EXPECT_FALSE(lost.challenger_first);
  EXPECT_EQ(lost.cuts, 0);
}

TEST(Divide, CutsAtTheVertexThatAPseudoSourceLiesOn) {
  // 150 degrees round a saddle vertex at (1, 0). The direct window is nearer except at (1, 0).
  const double turn = 150 * std::numbers::pi / 180;
  const Window direct{0, 1, 1 - std::cos(turn), std::sin(turn), 0}, apex{0, 1, 1, 0, 1};
  for (const bool apex_challenges : {false, true}) {
    const Window &challenger = apex_challenges ? apex : direct,
                 &incumbent = apex_challenges ? direct : apex;
    const Division division = divide(challenger, incumbent, 0, 1, 1e-14);
    EXPECT_EQ(division.challenger_first, !apex_challenges);
    for (int k = 0; k < division.cuts; ++k) EXPECT_NEAR(division.at[k], 1, 1e-13);
  }
}

TEST(Divide, GivesAPartToTheWindowThatWinsAtItsEndWhereItsMiddleTies) {
  // The edge is 10^9 times as long as the distance between the sources.
  const double length = 2040.5247154628253;
  const Window direct{0, length, 2040.5246677159985, 0.86776747693401113, 0};
  const Window bent{0, length, 2040.524667668041, 0.86776747691889888, 4.7957426051804675e-08};
  const Division division = divide(direct, bent, 0, length, 1e-14 * length);
  EXPECT_NE(division.challenger_first, division.cuts % 2 == 1);  // the last part is direct's
}

TEST(Divide, PrefersTheSmallerSigmaOfCoincidingSources) {
  const Window early = from_source(0.3, -0.7, 1), late = from_source(0.3, -0.7, 1.25);
  EXPECT_TRUE(divide(early, late, 0, 1, kNarrowest).challenger_first);
  EXPECT_FALSE(divide(late, early, 0, 1, kNarrowest).challenger_first);
}

TEST(Divide, NeverGivesAPartToAPseudoSourceInTheShadeOfItsParent) {
  // The ray from the parent through the pseudo-source meets the edge at 0.5, where both tie.
  const Window parent = from_source(0, -2, 0);
  const Window child = from_source(0.25, -1, std::hypot(0.25, 1.0));
  const Division division = divide(child, parent, 0, 1, kNarrowest);
  EXPECT_FALSE(division.challenger_first);
  EXPECT_EQ(division.cuts, 0);
}

TEST(Divide, FindsTheBisectorOfEqualSigmas) {
  const Window left = from_source(0, -1, 0), right = from_source(1, -1, 0);
  const Division division = divide(left, right, 0, 1, kNarrowest);
  EXPECT_TRUE(division.challenger_first);
  ASSERT_EQ(division.cuts, 1);
  EXPECT_DOUBLE_EQ(division.at[0], 0.5);
}

TEST(Divide, ScalesExactlyWithPowersOfTwo) {
  const Window a = from_source(0.1, -0.9, 1.2), b = from_source(0.7, -0.4, 1.5);
  const auto scaled = [](const Window& w) {
    return Window{1024 * w.begin, 1024 * w.end, 1024 * w.x, 1024 * w.y, 1024 * w.sigma};
  };
  const Division small = divide(a, b, 0, 1, kNarrowest);
  const Division large = divide(scaled(a), scaled(b), 0, 1024, 1024 * kNarrowest);
  ASSERT_EQ(small.cuts, 1);
  ASSERT_EQ(large.cuts, 1);
  EXPECT_EQ(large.at[0], 1024 * small.at[0]);
}

TEST(Crossings, AreEquallyFarFromBothSources) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    const Window a = from_source(uniform(random), uniform(random), 1 + 0.3 * uniform(random));
    const Window b = from_source(uniform(random), uniform(random), 1 + 0.3 * uniform(random));
    const Crossings both = crossings(a, b);
    for (int k = 0; k < both.count; ++k, ++found) {
      if (std::abs(both.at[k]) > 10) continue;  // nearly parallel to an asymptote
      EXPECT_NEAR(distance_at(a, both.at[k]), distance_at(b, both.at[k]), 1e-12) << "case " << i;
    }
  }
  EXPECT_GT(found, 500);
}

}  // namespace
}  // namespace geodesic::mmp
