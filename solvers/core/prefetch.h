// Bringing memory into the cache before it is read.
#pragma once

#include <array>
#include <cstddef>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Starts to load the cache line at an address; the address may be anything.
inline void prefetch(const void* address) { __builtin_prefetch(address); }

/// The items that a queue has announced (`upcoming`), one a turn, so that what their turn will read
/// can be loaded in stages, where each stage finds its address in what the one before has loaded.
template <std::size_t kStages>
class PrefetchPipeline {
 public:
  PrefetchPipeline() { clear(); }

  void clear() { items_.fill(kNone); }

  /// A turn passes. @param item the one announced now, or kNone
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
  static constexpr std::size_t kApart = 2;  // turns; memory takes longer than one to answer

  std::array<Index, (kStages - 1) * kApart + 1> items_;
  std::size_t at_ = 0;
};

}  // namespace geodesic
