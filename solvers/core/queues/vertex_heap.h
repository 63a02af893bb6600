// Vertices in order of a distance that may decrease while they wait: an indexed 4-ary heap.
#pragma once

#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Holds each vertex at most once; a smaller key moves it forward.
class VertexHeap {
 public:
  /// @param vertices number of vertices; ids run from 0 to vertices - 1
  explicit VertexHeap(Index vertices) : slot_(vertices, kNone) {}

  bool empty() const { return heap_.empty(); }
  bool contains(Index v) const { return slot_[v] != kNone; }
  double least_key() const { return heap_.front().key; }

  void clear() {
    for (const Entry& entry : heap_) slot_[entry.vertex] = kNone;
    heap_.clear();
  }

  /// Inserts v, or moves it forward when it is there with a larger key.
  void push_or_decrease(Index v, double key) {
    if (slot_[v] == kNone) {
      slot_[v] = static_cast<Index>(heap_.size());
      heap_.push_back({key, v});
    } else if (!(key < heap_[slot_[v]].key)) {
      return;
    }
    sift_up(slot_[v], {key, v});
  }

  /// Removes and returns the vertex of least key, of smallest id among equals. Must not be empty.
  Index pop() {
    const Index least = heap_.front().vertex;
    slot_[least] = kNone;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sift_down(0, last);
    return least;
  }

 private:
  struct Entry {
    double key;
    Index vertex;
    bool operator<(const Entry& other) const {
      return key < other.key || (key == other.key && vertex < other.vertex);
    }
  };

  void put(Index at, const Entry& entry) {
    heap_[at] = entry;
    slot_[entry.vertex] = at;
  }

  void sift_up(Index at, const Entry& entry) {
    while (at > 0 && entry < heap_[(at - 1) / 4]) {
      put(at, heap_[(at - 1) / 4]);
      at = (at - 1) / 4;
    }
    put(at, entry);
  }

  void sift_down(Index at, const Entry& entry) {
    const Index size = static_cast<Index>(heap_.size());
    for (Index first = 4 * at + 1; first < size; first = 4 * at + 1) {
      Index least = first;
      for (Index child = first + 1; child < size && child < first + 4; ++child) {
        if (heap_[child] < heap_[least]) least = child;
      }
      if (!(heap_[least] < entry)) break;
      put(at, heap_[least]);
      at = least;
    }
    put(at, entry);
  }

  std::vector<Entry> heap_;
  std::vector<Index> slot_;  // position of each vertex in heap_, kNone when not in it
};

}  // namespace geodesic
