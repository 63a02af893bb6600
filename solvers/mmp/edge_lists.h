// The sorted windows of every edge; each list is one array, with room at both ends.
//
// A list is named by a half-edge, whose frame its windows use (edge_window.h). A window ends where
// the next one begins, so that rounding creates neither gaps nor overlaps.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/pool.h"
#include "solvers/core/prefetch.h"

namespace geodesic::mmp {

/// The list of windows that leave a face through a half-edge. There is one list per edge (Liu
/// 2013), for windows of both sides, named by the smaller of the twins.
/// @param twin kNone, which is larger than any half-edge, on the boundary
inline Index list_of(Index half_edge, Index twin) { return std::min(half_edge, twin); }

/// A window in a list.
struct ListedWindow {
  double begin;  ///< position on the edge
  Index number;  ///< of the window
};

/// The windows of an edge, in order. Behind the last one the list has the edge's end.
struct EdgeList {
  ListedWindow* windows = nullptr;
  std::uint32_t size = 0;  ///< without the edge's end
  std::uint32_t room_before = 0, capacity = 0;

  std::span<const ListedWindow> all() const { return {windows, size}; }
  double end_of(std::size_t i) const { return windows[i + 1].begin; }

  /// Index of the last window that begins at t or before. Nearly all searches end at the first
  /// window or at one of the last two; the others are binary. The list must not be empty.
  std::size_t at(double t) const {
    const std::size_t likely =
        windows[1].begin > t ? 0 : size - 1u - (windows[size - 1].begin > t ? 1u : 0u);
    if (windows[likely].begin <= t) [[likely]] {
      return likely;
    }
    const auto begins_behind = [](double position, const ListedWindow& w) {
      return position < w.begin;
    };
    const auto next = std::upper_bound(windows + 1, windows + size, t, begins_behind);
    return static_cast<std::size_t>(next - windows) - 1;
  }
};

/// Lists by the half-edges that name them. A list is empty until it is opened. Its windows then
/// partition the edge, until the list is closed; it then stays empty.
class EdgeLists {
 public:
  explicit EdgeLists(Index half_edges) : lists_(half_edges) {}

  void clear() {
    std::fill(lists_.begin(), lists_.end(), EdgeList{});
    segments_.clear();
  }

  const EdgeList& operator[](Index edge) const { return lists_[edge]; }
  /// Upper bound of the names of edges, whether reached or not.
  Index edge_bound() const { return static_cast<Index>(lists_.size()); }

  bool is_closed(Index edge) const { return lists_[edge].capacity == kClosed; }

  /// Gives an empty list its first window, over the whole edge.
  void open(Index edge, double length, Index window) {
    const std::uint32_t capacity = Segments::capacity_for(kFirstRoom), room = capacity / 2 - 1;
    EdgeList& list = lists_[edge] = {segments_.take(capacity) + room, 1, room, capacity};
    list.windows[0] = {0, window};
    list.windows[1] = {length, kNone};
  }

  /// Replaces windows [first, last) of an edge's list by windows stored elsewhere. Of the parts
  /// before and behind them, the shorter one moves.
  void replace(Index edge, std::size_t first, std::size_t last, std::span<const ListedWindow> by) {
    EdgeList& list = lists_[edge];
    const std::size_t used = list.size + 1u, behind = used - last;
    const std::ptrdiff_t more = std::ssize(by) - static_cast<std::ptrdiff_t>(last - first);
    const bool front_moves = first < behind;
    const std::uint32_t room =
        front_moves ? list.room_before : list.capacity - list.room_before - list.size - 1;
    if (more > std::ptrdiff_t{room}) [[unlikely]] {
      move_to_larger(list, used, static_cast<std::size_t>(more));
    }
    if (front_moves) {
      ListedWindow* const from = std::exchange(list.windows, list.windows - more);
      list.room_before = static_cast<std::uint32_t>(list.room_before - more);
      move(from, list.windows, first);
    } else {
      move(list.windows + last, list.windows + (first + by.size()), behind);
    }
    for (std::size_t k = 0; k < by.size(); ++k) list.windows[first + k] = by[k];
    list.size = static_cast<std::uint32_t>(list.size + more);
  }

  /// Closes a list that holds windows.
  void close(Index edge) {
    EdgeList& list = lists_[edge];
    segments_.give_back(list.windows - list.room_before, list.capacity);
    list = {.capacity = kClosed};
  }

  /// Start to load the place of an edge's list, and, once that is loaded, the list's ends, where
  /// nearly all windows land.
  void prefetch_list(Index edge) const { prefetch(&lists_[edge]); }
  void prefetch_ends(Index edge) const {
    prefetch(lists_[edge].windows);
    prefetch(lists_[edge].windows + lists_[edge].size);
  }

 private:
  static constexpr std::uint32_t kClosed = ~0u;  // stored as the capacity
  static constexpr std::uint32_t kFirstRoom = 8;
  using Segments = SegmentPool<ListedWindow>;

  // A few windows, for which a call takes longer.
  static void move(const ListedWindow* from, ListedWindow* to, std::size_t windows) {
    if (to < from) {
      for (std::size_t k = 0; k < windows; ++k) to[k] = from[k];
    } else {
      for (std::size_t k = windows; k-- > 0;) to[k] = from[k];
    }
  }

  // Moves a list into an array with room for at least `more` windows at both ends.
  // @param used what the list holds, with the edge's end
  void move_to_larger(EdgeList& list, std::size_t used, std::size_t more) {
    const std::uint32_t capacity =
        Segments::capacity_for(static_cast<std::uint32_t>(used + 2 * more));
    const std::uint32_t room = (capacity - static_cast<std::uint32_t>(used)) / 2;
    ListedWindow* const larger = segments_.take(capacity);
    std::copy(list.windows, list.windows + used, larger + room);
    segments_.give_back(list.windows - list.room_before, list.capacity);
    list = {larger + room, list.size, room, capacity};
  }

  std::vector<EdgeList> lists_;
  Segments segments_;
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
