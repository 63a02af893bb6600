// Progress of a recorded solve, measured in the same way for every algorithm.
#pragma once

#include <cstdint>

#include "solvers/core/start.h"

namespace geodesic {

/// Counts the vertices that have a finite distance. Progress is their share of all vertices that
/// some path joins to a source. It therefore ends at 1 on any mesh (earlier with a distance limit).
class Progress {
 public:
  static constexpr std::uint64_t kSteps = 64;  // number of equally spaced samples

  /// Starts a solve: no vertex is reached, not even a source.
  void start(const Mesh& mesh, const Start& start);

  /// Call when a vertex gets a new distance. @param former its distance before
  void improved(double former) { reached_ += former == kInfinity ? 1u : 0u; }

  Index reached() const { return reached_; }
  double share() const { return static_cast<double>(reached_) / static_cast<double>(reachable_); }

  /// True when at least one step was made since the last call that returned true. Steps made at
  /// once count as one.
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
