// Threads of a team that take their pieces in ever other orders.
#pragma once

namespace geodesic {

/// From now on all threads of teams wait for a while before some pieces, or no longer do
/// (solvers/core/thread_team.cpp).
void delay_pieces(bool delays);

/// Delays pieces during its lifetime.
class DelayedPieces {
 public:
  DelayedPieces() { delay_pieces(true); }
  ~DelayedPieces() { delay_pieces(false); }
  DelayedPieces(const DelayedPieces&) = delete;
  DelayedPieces& operator=(const DelayedPieces&) = delete;
};

}  // namespace geodesic
