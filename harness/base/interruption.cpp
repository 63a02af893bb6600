#include "harness/base/interruption.h"

#include <cstring>
#include <ctime>
#include <string>

namespace geodesic::harness {
namespace {

volatile std::sig_atomic_t received = 0;
volatile std::sig_atomic_t received_at = 0;  // seconds

// Calls only functions that a signal handler may call.
void remember(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const auto seconds = static_cast<std::sig_atomic_t>(now.tv_sec);
  if (received == 0) {
    received = signal;
    received_at = seconds;
  } else if (seconds - received_at > 1) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(std::string("interrupted (") + strsignal(signal) + ")"), signal_(signal) {}

InterruptionGuard::InterruptionGuard() {
  received = 0;
  struct sigaction remembered {};
  remembered.sa_handler = remember;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &remembered, nullptr);
  }
}

InterruptionGuard::~InterruptionGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

void throw_if_interrupted() {
  if (received != 0) throw Interrupted(received);
}

}  // namespace geodesic::harness
