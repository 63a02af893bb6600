// The sorted windows of every edge, each list in one piece of memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/prefetch.h"
#include "solvers/mmp/segment_pool.h"

namespace geodesic::mmp {

/// Lists by the half-edges they go by (list_layout.h). A list is empty until something reaches its
/// edge; from then on its windows partition the edge, until the list is closed: it is empty again,
/// for good.
template <class W>
class EdgeLists {
  static_assert(std::is_trivially_copyable_v<W>);

 public:
  explicit EdgeLists(Index half_edges) : lists_(half_edges) {}

  void clear() {
    std::fill(lists_.begin(), lists_.end(), List{});
    pool_.clear();
  }

  std::span<W> windows(Index edge) { return {lists_[edge].windows, lists_[edge].size}; }
  std::span<const W> windows(Index edge) const { return {lists_[edge].windows, lists_[edge].size}; }

  bool is_closed(Index edge) const { return lists_[edge].capacity == kClosed; }

  /// Starts to bring near where an edge's list is, and, once that is near, the list itself: its
  /// ends, where most windows land, and its middle, where a search begins.
  void fetch(Index edge) const { prefetch(&lists_[edge]); }
  void fetch_windows(Index edge) const {
    const List& list = lists_[edge];
    prefetch(list.windows);
    prefetch(list.windows + list.size / 2);
    prefetch(list.windows + list.size);
  }

  /// Number of edges, reached or not, as the upper bound of their names.
  Index edge_bound() const { return static_cast<Index>(lists_.size()); }

  /// Replaces windows [first, last) of an edge's list by others, which lie elsewhere in memory.
  void replace(Index edge, std::size_t first, std::size_t last, std::span<const W> by) {
    List& list = lists_[edge];
    const std::size_t behind = list.size - last;
    const std::size_t size = first + by.size() + behind;
    if (size > list.capacity) {
      move_to_larger(list, first, last, by.size(), static_cast<std::uint32_t>(size));
    } else if (by.size() != last - first) {
      std::memmove(list.windows + first + by.size(), list.windows + last, behind * sizeof(W));
    }
    std::copy(by.begin(), by.end(), list.windows + first);
    list.size = static_cast<std::uint32_t>(size);
  }

  /// Closes a list that holds windows.
  void close(Index edge) {
    List& list = lists_[edge];
    pool_.give_back(list.windows, list.capacity);
    list = {.capacity = kClosed};
  }

 private:
  static constexpr std::uint32_t kClosed = ~0u;  // in place of a capacity

  struct List {
    W* windows = nullptr;
    std::uint32_t size = 0, capacity = 0;
  };

  // Leaves room for `between` windows in place of [first, last).
  void move_to_larger(List& list, std::size_t first, std::size_t last, std::size_t between,
                      std::uint32_t size) {
    const std::uint32_t capacity = SegmentPool<W>::capacity_for(size);
    W* larger = pool_.take(capacity);
    if (list.capacity > 0) {
      std::copy(list.windows, list.windows + first, larger);
      std::copy(list.windows + last, list.windows + list.size, larger + first + between);
      pool_.give_back(list.windows, list.capacity);
    }
    list.windows = larger;
    list.capacity = capacity;
  }

  std::vector<List> lists_;
  SegmentPool<W> pool_;
};

}  // namespace geodesic::mmp
