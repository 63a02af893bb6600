// What a Chen-Han solver keeps of a window while it waits, and where.
#pragma once

#include <vector>

#include "solvers/core/window.h"

namespace geodesic::chen_han {

/// Which end of its half-edge a window's edge shares with the edge through which the window's lines
/// came into the face that they are leaving.
enum class Entry : Index { at_origin, at_head };

/// A window that waits to be propagated across the face of `half_edge`. An empty interval stands
/// for the pseudo-source `root` itself, which waits to send out windows: its path arrived at the
/// corner `half_edge` from the direction (x, y) (shadow.h).
template <class Depth>
struct StoredWindow : Window {
  Index half_edge;
  Index root : 31;                    ///< vertex of the (pseudo-)source
  Index entry : 1;                    ///< an Entry
  [[no_unique_address]] Depth depth;  ///< faces crossed since the pseudo-source

  bool is_pseudo_source() const { return !(end > begin); }
};

/// As many vertices as `StoredWindow::root` can tell apart.
inline constexpr Index kMaxVertices = (Index{1} << 31) - 1;

/// Slots for waiting windows. One set free is used next, while it is still in the cache.
template <class Item>
class Pool {
 public:
  void clear() {
    slots_.clear();
    free_.clear();
  }

  Index add(const Item& item) {
    if (free_.empty()) {
      slots_.push_back(item);
      return static_cast<Index>(slots_.size() - 1);
    }
    const Index slot = free_.back();
    free_.pop_back();
    slots_[slot] = item;
    return slot;
  }

  /// Of a slot that was given out since the last `clear`, taken or not.
  const Item& operator[](Index slot) const { return slots_[slot]; }

  /// Removes and returns the item of a slot.
  Item take(Index slot) {
    free_.push_back(slot);
    return slots_[slot];
  }

  /// Calls visit(item) for every item, in the order of slots.
  template <class Visit>
  void for_each(Visit&& visit) const {
    std::vector<bool> is_free(slots_.size());
    for (const Index slot : free_) is_free[slot] = true;
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
      if (!is_free[slot]) visit(slots_[slot]);
    }
  }

 private:
  std::vector<Item> slots_;
  std::vector<Index> free_;
};

}  // namespace geodesic::chen_han
