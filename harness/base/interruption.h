// Turns Ctrl-C, SIGTERM and SIGHUP into an exception, so that computed results are kept.
#pragma once

#include <array>
#include <csignal>
#include <stdexcept>

namespace geodesic::harness {

/// Not a HarnessError, because an interruption is not a failure of a cell. main exits with
/// 128 + signal, as a shell does.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal);
  int exit_code() const { return 128 + signal_; }

 private:
  int signal_;
};

/// While it exists, SIGINT, SIGTERM and SIGHUP make throw_if_interrupted throw and do not end the
/// program. Another signal more than a second later ends it at once (timeout sends two together).
/// A signal that is ignored stays ignored (nohup). At most one guard exists at a time.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

  static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

 private:
  std::array<struct sigaction, kSignals.size()> before_;
};

/// @throws Interrupted when a signal has come since the guard was made
void throw_if_interrupted();

}  // namespace geodesic::harness
