// The user's Ctrl-C, and its like, as an exception: what was computed is kept, and said.
#pragma once

#include <array>
#include <csignal>
#include <stdexcept>

namespace geodesic::harness {

/// Not a HarnessError: it is no cell's failure. main exits with 128 + signal, as a shell does.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int signal);
  int exit_code() const { return 128 + signal_; }

 private:
  int signal_;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP end nothing by themselves but make
/// throw_if_interrupted throw; a second one ends the program at once. A signal that is ignored
/// stays ignored (nohup). At most one lives at a time.
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
