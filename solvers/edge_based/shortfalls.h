// By how much the distances of vertices may be too short (merge.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/edge_based/merge.h"

namespace geodesic::edge_based {

/// Stored as shares of the greatest allowed one, rounded up: 16 bits per vertex.
class Shortfalls {
 public:
  /// @param most the greatest shortfall, relative to distances
  explicit Shortfalls(double most) : unit_(most / kWhole) {}

  void start(std::span<const double> distances) {
    distances_ = distances;
    shares_.assign(distances.size(), 0);
  }
  float of(Index v) const { return internal::rounded_up(unit_ * shares_[v] * distances_[v]); }
  void set(Index v, float missing) {
    const double share = missing > 0 ? missing / (unit_ * distances_[v]) : 0;
    shares_[v] = static_cast<std::uint16_t>(std::min(std::ceil(share), kWhole));
  }

 private:
  static constexpr double kWhole = UINT16_MAX;

  double unit_;
  std::span<const double> distances_;
  std::vector<std::uint16_t> shares_;
};

}  // namespace geodesic::edge_based
