// The number of windows that a solve may propagate before it counts as endless.
//
// Around the tip of needles, and around a tube of them, windows wind as often as the needles are
// longer than wide. If a solver keeps no window that has passed, only paths over vertices beat such
// a window, and these vertices are far away. Each turn may be longer by less than rounding, which
// shortens some by more: a distance then comes out too short. No shortest path enters a face twice:
// between two points of a face the straight line in it is shorter. A strip of faces therefore has
// at most as many faces as the mesh. On meshes with thin faces (Mesh::has_thin_faces) windows store
// the length of their strip, and those with a longer strip are dropped. On other meshes angles
// bound the number of turns.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "solvers/core/mesh.h"

namespace geodesic {

/// Thrown by a solve that exceeds its bound. The solver object can be used again.
class EndlessPropagation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// 1024 H sqrt(H) + 2^20 windows on a mesh of H half-edges.
///
/// Solvers that drop beaten windows stay below a thousandth of it on every mesh of the conformance
/// properties, including those with thousands of ties, valences and boundary loops. `ch` drops
/// nothing and is meant for 1,200 vertices. It propagates up to 0.2 H^2 windows: a hundredth of the
/// bound on a box of 1,200 faces. Chen and Han 1990 bound their windows by H^2, which meshes
/// made for it need; up to H = 2^20, 350,000 faces, that is below this bound too.
std::uint64_t window_bound(const Mesh& mesh);

/// True when no shortest path has a strip of `faces` faces, including the one entered next.
/// @param face_count of the mesh
inline bool is_strip_too_long(Index face_count, std::uint64_t faces) { return faces > face_count; }

/// The remaining number of windows in a solve.
class WindowBudget {
 public:
  explicit WindowBudget(const Mesh& mesh)
      : faces_(mesh.face_count()), bound_(static_cast<std::int64_t>(window_bound(mesh))) {}

  /// Call at the beginning of every solve.
  void start() { left_ = bound_; }

  /// Call before `windows` windows are propagated across a face. A window or pseudo-source that a
  /// queue returns may be counted before it is known whether it propagates.
  /// @throws EndlessPropagation when the bound is exceeded
  void spend(std::size_t windows) {
    left_ -= static_cast<std::int64_t>(windows);
    if (left_ < 0) [[unlikely]] {
      report();
    }
  }

  /// Number of faces of the mesh.
  Index face_count() const { return faces_; }
  /// Number of windows since the beginning of the solve.
  std::uint64_t spent() const { return static_cast<std::uint64_t>(bound_ - left_); }

 private:
  [[noreturn]] void report() const;

  Index faces_;
  std::int64_t bound_;
  std::int64_t left_ = bound_;
};

}  // namespace geodesic
