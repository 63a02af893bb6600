#include "harness/measure/phases.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

// 4 seconds, of which 100 readings.
PhaseTimes four_seconds(double reading) {
  return {.propagation = {2, 40}, .trimming = {1.5, 10}, .queue = {0.5, 50}, .reading = reading};
}

double sum(const Json& json) {
  double sum = 0;
  for (const Json& value : json) sum += value.get<double>();
  return sum;
}

TEST(PhaseSeconds, GiveWhatTheTimersAddedToThePhasesByTheirReadings) {
  const Json json = phase_seconds(four_seconds(1), 3.5);
  EXPECT_DOUBLE_EQ(json["propagation"].get<double>(), 2 - 0.2);
  EXPECT_DOUBLE_EQ(json["trimming"].get<double>(), 1.5 - 0.05);
  EXPECT_DOUBLE_EQ(json["queue"].get<double>(), 0.5 - 0.25);
  EXPECT_DOUBLE_EQ(json["timer_overhead"].get<double>(), 0.5);
}

TEST(PhaseSeconds, TakeOutNoMoreThanReadingsCostAlone) {
  const Json json = phase_seconds(four_seconds(0.001), 1);
  EXPECT_DOUBLE_EQ(json["timer_overhead"].get<double>(), 0.1);
  EXPECT_DOUBLE_EQ(sum(json), 4);
}

TEST(PhaseSeconds, TakeOutNothingFromASolveThatWasFasterWithTimers) {
  const Json json = phase_seconds(four_seconds(1), 5);
  EXPECT_EQ(json["timer_overhead"].get<double>(), 0);
  EXPECT_DOUBLE_EQ(json["propagation"].get<double>(), 2);
}

TEST(PhaseSeconds, AreNeverNegative) {
  const Json json = phase_seconds(four_seconds(1), 0);
  EXPECT_EQ(json["queue"].get<double>(), 0);
  EXPECT_DOUBLE_EQ(json["timer_overhead"].get<double>(), 1.6 + 0.4 + 0.5);
  EXPECT_DOUBLE_EQ(sum(json), 4);
}

TEST(PhaseSeconds, OfNoTimeAreZero) { EXPECT_EQ(sum(phase_seconds({}, 0)), 0); }

}  // namespace
}  // namespace geodesic::harness
