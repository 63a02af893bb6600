#include "harness/base/interruption.h"

#include <cstring>
#include <string>

namespace geodesic::harness {
namespace {

volatile std::sig_atomic_t received = 0;

void remember(int signal) { received = signal; }

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(std::string("interrupted (") + strsignal(signal) + ")"), signal_(signal) {}

InterruptionGuard::InterruptionGuard() {
  received = 0;
  struct sigaction once {};
  once.sa_handler = remember;
  once.sa_flags = static_cast<int>(SA_RESETHAND);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &once, nullptr);
  }
}

InterruptionGuard::~InterruptionGuard() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

void throw_if_interrupted() {
  if (received != 0) throw Interrupted(received);
}

}  // namespace geodesic::harness
