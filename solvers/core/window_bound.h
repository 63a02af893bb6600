// How many windows a solve may propagate before it counts as endless.
//
// Around the tip of needles, and around a tube of them, windows wind as often as the needles are
// longer than wide: where a solver keeps nothing of a window that has passed, only paths over
// vertices beat what comes round, and these are far away. No shortest path enters a face twice:
// between the two points of a face the straight line in it is shorter. A strip of faces therefore
// has at most as many as the mesh. Windows need not carry the length of their strip for that: a
// solve without it that exceeds the bound is repeated with it, and drops what is longer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "solvers/core/mesh.h"

namespace geodesic {

/// Thrown by a solve that exceeds its bound. The object can be used again.
class EndlessPropagation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// 1024 H sqrt(H) + 2^20 windows on a mesh of H half-edges.
///
/// The solvers that drop what others beat stay below a thousandth of it on every mesh of the
/// conformance properties, those of ties, valences and boundary loops by the thousand included.
/// `ch`, which drops nothing and is meant for 1,200 vertices, propagates up to 0.7 H^2 windows: a
/// box of 1,200 faces took it a twenty-fifth of the bound. Chen and Han 1990 bound their windows by
/// H^2, which meshes made for it need; up to H = 2^20, 350,000 faces, that is below this bound too.
std::uint64_t window_bound(const Mesh& mesh);

/// Whether no shortest path has a strip of so many faces, the one that is entered next among them.
inline bool is_strip_too_long(const Mesh& mesh, std::uint64_t faces) {
  return faces > mesh.face_count();
}

/// Calls solve(false), which need not know how long strips are; and where that exceeds the bound,
/// solve(true), which drops those that are too long, from fresh distances.
template <class Solve>
void solve_within_bound(std::span<double> distances, const Solve& solve) {
  try {
    solve(false);
  } catch (const EndlessPropagation&) {
    std::ranges::fill(distances, kInfinity);
    solve(true);
  }
}

/// What is left of the bound in a solve.
class WindowBudget {
 public:
  explicit WindowBudget(const Mesh& mesh)
      : faces_(mesh.face_count()), bound_(static_cast<std::int64_t>(window_bound(mesh))) {}

  /// At the beginning of every solve.
  void start() { left_ = bound_; }

  /// Before so many windows are propagated across a face. A window or pseudo-source that a queue
  /// gives back may count before it is known whether it goes on.
  /// @throws EndlessPropagation when the bound is exceeded
  void spend(std::size_t windows) {
    left_ -= static_cast<std::int64_t>(windows);
    if (left_ < 0) [[unlikely]] {
      report();
    }
  }

  /// Windows since the beginning of the solve.
  std::uint64_t spent() const { return static_cast<std::uint64_t>(bound_ - left_); }

 private:
  [[noreturn]] void report() const;

  Index faces_;
  std::int64_t bound_;
  std::int64_t left_ = bound_;
};

/// For tests: as long as it lives, the bound of solvers that its thread prepares is at most `most`.
class LoweredWindowBound {
 public:
  explicit LoweredWindowBound(std::uint64_t most);
  ~LoweredWindowBound();
  LoweredWindowBound(const LoweredWindowBound&) = delete;
  LoweredWindowBound& operator=(const LoweredWindowBound&) = delete;
};

}  // namespace geodesic
