// How far a recorded solve has come, measured the same way for every algorithm.
#pragma once

#include <cstdint>
#include <span>

#include "solvers/core/mesh.h"

namespace geodesic {

/// Counts the vertices that have a finite distance. Progress is their share of all vertices
/// that some path joins to a source, so that it ends at 1 on any mesh (with a distance limit,
/// earlier).
class Progress {
 public:
  static constexpr std::uint64_t kSteps = 64;  // moments for samples, equally far apart

  /// Nothing is reached yet, not even the sources.
  void start(const Mesh& mesh, std::span<const Index> sources);

  /// A vertex gets a new distance. @param former its distance until now
  void reach(double former) { reached_ += former == kInfinity ? 1u : 0u; }

  Index reached() const { return reached_; }
  double share() const { return static_cast<double>(reached_) / static_cast<double>(reachable_); }

  /// True once for every step that was made since the last call returned true; one call for all if
  /// they were made at once.
  bool made_step() {
    if (reached_ * kSteps < next_step_ * reachable_) return false;
    next_step_ = reached_ * kSteps / reachable_ + 1;
    return true;
  }

 private:
  Index reached_ = 0;
  std::uint64_t reachable_ = 1;
  std::uint64_t next_step_ = 1;
};

}  // namespace geodesic
