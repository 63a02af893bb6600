// Loading memory into the cache before it is read.
#pragma once

#include <array>
#include <cstddef>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Starts to load the cache line at an address; any address is allowed. The empty volatile
/// statement is a side effect: without one, GCC takes functions that only prefetch for pure, and
/// drops calls.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");
}

/// The items that a queue has announced (`upcoming`), one per turn. Their data is loaded in stages:
/// the address for each stage is in the data that the stage before has loaded.
template <std::size_t kStages>
class PrefetchPipeline {
 public:
  PrefetchPipeline() { clear(); }

  void clear() { items_.fill(kNone); }

  /// Moves every item on by one turn. @param item the one announced now, or kNone
  void advance(Index item) {
    at_ = at_ == 0 ? items_.size() - 1 : at_ - 1;
    items_[at_] = item;
  }

  /// The item announced stage * kApart turns ago, kNone when none was announced then.
  Index operator[](std::size_t stage) const {
    const std::size_t place = at_ + stage * kApart;
    return items_[place < items_.size() ? place : place - items_.size()];
  }

 private:
  static constexpr std::size_t kApart = 2;  // turns; loading takes longer than one turn

  std::array<Index, (kStages - 1) * kApart + 1> items_;
  std::size_t at_ = 0;
};

}  // namespace geodesic
