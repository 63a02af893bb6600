// A bound of windows that small meshes exceed.
#pragma once

#include <cstdint>
#include <limits>

namespace geodesic {

/// From now on the bound of solvers that this thread prepares is at most `most`
/// (solvers/core/window_bound.cpp).
void lower_window_bound(std::uint64_t most);

/// Lowers it during its lifetime.
class LoweredWindowBound {
 public:
  explicit LoweredWindowBound(std::uint64_t most) { lower_window_bound(most); }
  ~LoweredWindowBound() { lower_window_bound(std::numeric_limits<std::uint64_t>::max()); }
  LoweredWindowBound(const LoweredWindowBound&) = delete;
  LoweredWindowBound& operator=(const LoweredWindowBound&) = delete;
};

}  // namespace geodesic
