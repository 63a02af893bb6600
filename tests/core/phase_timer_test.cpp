#include "solvers/core/phase_timer.h"

#include <gtest/gtest.h>

namespace geodesic {
namespace {

/// A clock that advances only by the work of a test and by the cost of a reading.
struct FakeClock {
  static constexpr std::uint64_t kReading = 3;
  static inline std::uint64_t now = 0;

  static std::uint64_t ticks() { return now += kReading; }
  static double seconds() { return static_cast<double>(now) / 1000; }
  static void work(std::uint64_t ticks) { now += ticks; }
};
using FakeTimer = BasicPhaseTimer<FakeClock>;
using Scope = PhaseScope<FakeTimer>;

constexpr double kTick = 1e-3;

TEST(PhaseTimer, GivesEachPhaseItsWorkAndItsReadings) {
  FakeTimer timer;
  FakeClock::work(999);  // outside all phases
  {
    const Scope whole(timer, Phase::propagation);
    FakeClock::work(100);
    for (int i = 0; i < 5; ++i) {
      const Scope trimming(timer, Phase::trimming);
      FakeClock::work(20);
      {
        const Scope queue(timer, Phase::queue);
        FakeClock::work(7);
      }
      FakeClock::work(1);
    }
  }
  FakeClock::work(999);
  const PhaseTimes times = timer.times();
  EXPECT_EQ(times.propagation.readings, 6u);
  EXPECT_EQ(times.trimming.readings, 10u);
  EXPECT_EQ(times.queue.readings, 5u);
  const auto net = [&](const PhaseTimes::Share& share) {
    return share.seconds - kTick * FakeClock::kReading * static_cast<double>(share.readings);
  };
  EXPECT_DOUBLE_EQ(net(times.propagation), kTick * 100);
  EXPECT_DOUBLE_EQ(net(times.trimming), kTick * 5 * 21);
  EXPECT_DOUBLE_EQ(net(times.queue), kTick * 5 * 7);
}

TEST(PhaseTimer, OfTheRealClockAddsUpToNoMoreThanTheTimeThatPassed) {
  const double before = TickClock::seconds();
  PhaseTimer timer;
  volatile double sum = 0;
  {
    const PhaseScope whole(timer, Phase::propagation);
    for (int i = 0; i < 20000; ++i) {
      const PhaseScope queue(timer, Phase::queue);
      sum = sum + 1;
    }
  }
  const PhaseTimes times = timer.times();
  const double passed = TickClock::seconds() - before;
  EXPECT_EQ(times.queue.readings, 20000u);
  EXPECT_EQ(times.propagation.readings, 20001u);
  EXPECT_LE(times.propagation.seconds + times.queue.seconds, passed * 1.01);
}

}  // namespace
}  // namespace geodesic
