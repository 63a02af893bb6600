#include "harness/measure/recorded_solve.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

// 4 seconds in all, with 100 clock readings.
constexpr PhaseTimes kFourSeconds{
    .propagation = {2, 40}, .trimming = {1.5, 10}, .queue = {0.5, 50}};

double sum(const PhaseSeconds& seconds) {
  return seconds.propagation + seconds.trimming + seconds.queue + seconds.timer_overhead;
}

TEST(PhaseSeconds, GiveWhatTheTimersAddedToThePhasesByTheirReadings) {
  const PhaseSeconds seconds = phase_seconds(kFourSeconds, 3.5);
  EXPECT_DOUBLE_EQ(seconds.propagation, 2 - 0.2);
  EXPECT_DOUBLE_EQ(seconds.trimming, 1.5 - 0.05);
  EXPECT_DOUBLE_EQ(seconds.queue, 0.5 - 0.25);
  EXPECT_DOUBLE_EQ(seconds.timer_overhead, 0.5);
}

TEST(PhaseSeconds, TakeOutNothingFromASolveThatWasFasterWithTimers) {
  const PhaseSeconds seconds = phase_seconds(kFourSeconds, 5);
  EXPECT_EQ(seconds.timer_overhead, 0);
  EXPECT_DOUBLE_EQ(seconds.propagation, 2);
}

TEST(PhaseSeconds, AreNeverNegative) {
  const PhaseSeconds seconds = phase_seconds(kFourSeconds, 0);
  EXPECT_EQ(seconds.queue, 0);
  EXPECT_DOUBLE_EQ(seconds.timer_overhead, 1.6 + 0.4 + 0.5);
  EXPECT_DOUBLE_EQ(sum(seconds), 4);
}

TEST(PhaseSeconds, OfNoTimeAreZero) { EXPECT_EQ(sum(phase_seconds({}, 0)), 0); }

}  // namespace
}  // namespace geodesic::harness
