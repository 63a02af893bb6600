// The sorted windows of every edge; each list is one array.
//
// A list is named by a half-edge, whose frame its windows use (edge_window.h). Windows of one list
// are trimmed against each other.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "solvers/core/pool.h"
#include "solvers/core/prefetch.h"

namespace geodesic::mmp {

/// The list of windows that leave a face through a half-edge. There is one list per edge (Liu
/// 2013), for windows of both sides, named by the smaller of the twins.
/// @param twin kNone, which is larger than any half-edge, on the boundary
inline Index list_of(Index half_edge, Index twin) { return std::min(half_edge, twin); }

/// Lists by the half-edges that name them. A list is empty until a window reaches its edge. From
/// then on its windows partition the edge, until the list is closed; it then stays empty.
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

  /// Start to load the place of an edge's list, and, once that is loaded, the list: its ends, where
  /// most windows land, and its middle, where a search begins.
  void prefetch_list(Index edge) const { prefetch(&lists_[edge]); }
  void prefetch_windows(Index edge) const {
    const List& list = lists_[edge];
    prefetch(list.windows);
    prefetch(list.windows + list.size / 2);
    prefetch(list.windows + list.size);
  }

  /// Upper bound of the names of edges, whether reached or not.
  Index edge_bound() const { return static_cast<Index>(lists_.size()); }

  /// Replaces windows [first, last) of an edge's list by windows stored elsewhere.
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
  static constexpr std::uint32_t kClosed = ~0u;  // stored as the capacity

  struct List {
    W* windows = nullptr;
    std::uint32_t size = 0, capacity = 0;
  };

  // Moves a list and leaves room for `between` windows in place of [first, last).
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

/// The lists that hold windows and that the wavefront may have passed. They are checked each time
/// their number has grown by a quarter: at most five checks per list, however many lists stay.
class OpenLists {
 public:
  void clear() {
    lists_.clear();
    due_ = kFirst;
  }

  /// @param list the half-edge that names it; add each list once
  void add(Index list) { lists_.push_back(list); }

  bool is_due() const { return lists_.size() >= due_; }

  /// Calls is_done(list) for all lists, and removes those for which it returns true.
  template <class IsDone>
  void look_through(IsDone&& is_done) {
    std::erase_if(lists_, is_done);
    due_ = std::max(lists_.size() + lists_.size() / 4, kFirst);
  }

 private:
  static constexpr std::size_t kFirst = 1024;

  std::vector<Index> lists_;
  std::size_t due_ = kFirst;
};

}  // namespace geodesic::mmp
