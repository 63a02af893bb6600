// Items in order of their key, equal keys in order of insertion: a 4-ary heap.
#pragma once

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
  void clear() {
    heap_.clear();
    serial_ = 0;
  }

  void push(double key, Item item) {
    heap_.push_back({key, serial_++, item});
    sift_up(heap_.size() - 1);
  }

  /// Removes and returns the item of least key. The queue must not be empty.
  Item pop() {
    const Item least = heap_.front().item;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sift_down(last);
    return least;
  }

 private:
  struct Entry {
    double key;
    std::uint32_t serial;  // breaks ties, so that counters do not depend on the heap's shape
    Item item;
    bool operator<(const Entry& other) const {
      return key < other.key || (key == other.key && serial < other.serial);
    }
  };

  void sift_up(std::size_t at) {
    const Entry entry = heap_[at];
    while (at > 0) {
      const std::size_t parent = (at - 1) / 4;
      if (!(entry < heap_[parent])) break;
      heap_[at] = heap_[parent];
      at = parent;
    }
    heap_[at] = entry;
  }

  void sift_down(const Entry& entry) {
    std::size_t at = 0;
    for (;;) {
      const std::size_t first = 4 * at + 1;
      if (first >= heap_.size()) break;
      std::size_t least = first;
      const std::size_t end = first + 4 < heap_.size() ? first + 4 : heap_.size();
      for (std::size_t child = first + 1; child < end; ++child) {
        if (heap_[child] < heap_[least]) least = child;
      }
      if (!(heap_[least] < entry)) break;
      heap_[at] = heap_[least];
      at = least;
    }
    heap_[at] = entry;
  }

  std::vector<Entry> heap_;
  std::uint32_t serial_ = 0;
};

}  // namespace geodesic
