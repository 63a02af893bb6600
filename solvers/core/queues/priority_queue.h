// Items in order of their key, equal keys in order of insertion: a 4-ary heap.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic {

/// Queue policy of MMP and ICH. Items are small and trivially copyable (an index).
template <class Item>
class PriorityQueue {
 public:
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  /// Key of the item that `pop` would return. The queue must not be empty.
  double least_key() const { return std::bit_cast<double>(heap_.front().key); }
  void clear() {
    heap_.clear();
    serial_ = 0;
  }

  /// @param key not negative
  void push(double key, Item item) {
    const Entry entry{std::bit_cast<std::uint64_t>(key), serial_++, item};
    heap_.push_back(entry);
    sift_up(heap_.size() - 1, entry);
  }

  /// Removes and returns the item of least key. The queue must not be empty.
  Item pop() {
    const Item least = heap_.front().item;
    const Entry last = heap_.back();
    heap_.pop_back();
    // The last entry belongs near the leaves: let the hole sink all the way, then look upwards.
    if (!heap_.empty()) sift_up(sink_hole(), last);
    return least;
  }

 private:
  struct Entry {
    std::uint64_t key;     // bits of the key: doubles that are not negative compare like integers
    std::uint32_t serial;  // breaks ties, so that counters do not depend on the heap's shape
    Item item;
    // Without branches, since the outcome is unpredictable.
    bool operator<(const Entry& other) const {
      return static_cast<bool>((key < other.key) | ((key == other.key) & (serial < other.serial)));
    }
  };

  void sift_up(std::size_t at, const Entry& entry) {
    while (at > 0) {
      const std::size_t parent = (at - 1) / 4;
      if (!(entry < heap_[parent])) break;
      heap_[at] = heap_[parent];
      at = parent;
    }
    heap_[at] = entry;
  }

  // Moves the root's place down to a leaf along the least children.
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
  std::uint32_t serial_ = 0;
};

}  // namespace geodesic
