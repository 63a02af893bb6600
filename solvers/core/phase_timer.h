// The time that a solve spends in window propagation, trimming and queue maintenance (Figure 5.9 of
// the thesis).
//
// One phase runs at any moment, and the clock is read when the phase changes. A reading takes 10 to
// 40 ns, about as long as a short phase. Between two readings lies the cost of one reading: half of
// the first and half of the second. Times include it. The number of readings is reported too, so
// that the cost can be subtracted if the time without readings is known.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace geodesic {

enum class Phase : std::uint8_t {
  outside,      ///< not part of the solve, not reported
  propagation,  ///< everything else, unfolding and new distances above all
  trimming,     ///< finding useless windows, and cutting or dropping them
  queue,        ///< pushing, popping, and finding the window or vertex of an entry
};
inline constexpr std::size_t kPhases = 4;

/// Wall seconds of one solve, including the readings of the clock.
struct PhaseTimes {
  struct Share {
    double seconds = 0;
    std::uint64_t readings = 0;  ///< of the clock; the seconds include their cost

    bool operator==(const Share&) const = default;
  };
  Share propagation, trimming, queue;

  bool operator==(const PhaseTimes&) const = default;
};

/// A clock that is cheap to read, in a unit of its own; the same on all cores of the machine.
struct TickClock {
#if defined(__x86_64__)
  static std::uint64_t ticks() { return __rdtsc(); }
#else
  static std::uint64_t ticks() {
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
  }
#endif
  static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
};

/// @tparam Clock as TickClock
template <class Clock>
class BasicPhaseTimer {
 public:
  /// Ends the running phase and starts `next`. @return the phase that ended
  Phase change_to(Phase next) {
    const std::uint64_t now = Clock::ticks();
    Share& share = shares_[static_cast<std::size_t>(phase_)];
    share.ticks += now - last_;
    ++share.readings;
    last_ = now;
    const Phase ended = phase_;
    phase_ = next;
    return ended;
  }

  /// Returns the times since construction; the solve must be over.
  PhaseTimes times() const {
    const double ticks = static_cast<double>(Clock::ticks() - first_);
    const double unit = ticks > 0 ? (Clock::seconds() - started_) / ticks : 0;
    const auto share = [&](Phase phase) -> PhaseTimes::Share {
      const Share& own = shares_[static_cast<std::size_t>(phase)];
      return {unit * static_cast<double>(own.ticks), own.readings};
    };
    return {.propagation = share(Phase::propagation),
            .trimming = share(Phase::trimming),
            .queue = share(Phase::queue)};
  }

 private:
  struct Share {
    std::uint64_t ticks = 0, readings = 0;
  };

  std::array<Share, kPhases> shares_ = {};
  Phase phase_ = Phase::outside;
  std::uint64_t first_ = Clock::ticks();
  double started_ = Clock::seconds();
  std::uint64_t last_ = first_;
};

using PhaseTimer = BasicPhaseTimer<TickClock>;

/// Runs a phase until the end of a block, then resumes the phase that it interrupted.
template <class Timer>
class [[nodiscard]] PhaseScope {
 public:
  PhaseScope(Timer& timer, Phase phase) : timer_(timer), interrupted_(timer.change_to(phase)) {}
  ~PhaseScope() { timer_.change_to(interrupted_); }
  PhaseScope(const PhaseScope&) = delete;
  PhaseScope& operator=(const PhaseScope&) = delete;

 private:
  Timer& timer_;
  Phase interrupted_;
};

}  // namespace geodesic
