#include "solvers/core/thread_team.h"

namespace geodesic {
namespace {

constinit std::atomic<bool> pieces_are_delayed = false;

// A while that soon differs between threads.
void wait_a_while() {
  thread_local unsigned state = 0;
  state = state * 1664525u + 1013904223u;
  for (unsigned i = state >> 27; i > 0; --i) std::this_thread::yield();
}

}  // namespace

void delay_pieces(bool delays) { pieces_are_delayed.store(delays); }  // tests/delayed_pieces.h

bool ThreadTeam::take(std::size_t i) {
  if (taken_[i].exchange(true, std::memory_order_relaxed)) return false;
  if (pieces_are_delayed.load(std::memory_order_relaxed)) [[unlikely]] {
    wait_a_while();
  }
  return true;
}

}  // namespace geodesic
