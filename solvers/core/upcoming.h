// Items of a queue on their way to their turn.
#pragma once

#include <array>
#include <cstddef>

#include "solvers/core/geometry.h"

namespace geodesic {

/// The items that a queue told to be upcoming, one a turn, so that what their turn will read can be
/// fetched in stages, where each address lies behind the one before.
template <std::size_t kStages>
class Upcoming {
 public:
  Upcoming() { clear(); }

  void clear() { items_.fill(kNone); }

  /// A turn passes. @param item the one told now, or kNone
  void advance(Index item) {
    at_ = at_ == 0 ? items_.size() - 1 : at_ - 1;
    items_[at_] = item;
  }

  /// The item told stage * kApart turns ago, kNone when none was told then.
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
