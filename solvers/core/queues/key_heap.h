// Keyed items in order: a 4-ary heap.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic {

/// A queued item. Ordered by key, equal keys by serial number.
template <class Item>
struct KeyedItem {
  std::uint64_t key;     // bits of the key: non-negative doubles compare like integers
  std::uint32_t serial;  // breaks ties, so that counters do not depend on a queue's shape
  Item item;

  double key_value() const { return std::bit_cast<double>(key); }
  // Without branches, since the outcome is unpredictable.
  bool operator<(const KeyedItem& other) const {
    return static_cast<bool>((key < other.key) | ((key == other.key) & (serial < other.serial)));
  }
};

/// @tparam Item small and trivially copyable
template <class Item>
class KeyHeap {
 public:
  using Entry = KeyedItem<Item>;

  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  /// The heap must not be empty.
  const Entry& least() const { return heap_.front(); }
  void clear() { heap_.clear(); }

  void push(const Entry& entry) {
    heap_.push_back(entry);
    sift_up(heap_.size() - 1, entry);
  }

  /// Removes and returns the least entry. The heap must not be empty.
  Entry pop() {
    const Entry least = heap_.front();
    const Entry last = heap_.back();
    heap_.pop_back();
    // The last entry belongs near the leaves: move the hole all the way down, then sift up.
    if (!heap_.empty()) sift_up(sink_hole(), last);
    return least;
  }

 private:
  void sift_up(std::size_t at, const Entry& entry) {
    while (at > 0) {
      const std::size_t parent = (at - 1) / 4;
      if (!(entry < heap_[parent])) break;
      heap_[at] = heap_[parent];
      at = parent;
    }
    heap_[at] = entry;
  }

  // Moves a hole from the root down to a leaf, along the least children.
  std::size_t sink_hole() {
    Entry* const heap = heap_.data();
    const std::size_t size = heap_.size();
    std::size_t at = 0, first = 1;
    for (; first + 4 <= size; first = 4 * at + 1) {
      const std::size_t a = first + (heap[first + 1] < heap[first] ? 1 : 0);
      const std::size_t b = first + 2 + (heap[first + 3] < heap[first + 2] ? 1 : 0);
      const std::size_t least = heap[b] < heap[a] ? b : a;
      heap[at] = heap[least];
      at = least;
    }
    if (first < size) {
      std::size_t least = first;
      for (std::size_t child = first + 1; child < size; ++child) {
        if (heap[child] < heap[least]) least = child;
      }
      heap[at] = heap[least];
      at = least;
    }
    return at;
  }

  std::vector<Entry> heap_;
};

}  // namespace geodesic
