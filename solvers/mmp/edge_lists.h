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

/// End of window k of an edge's list. Behind the last window the array has the edge's end.
inline double end_of(std::span<const ListedWindow> list, std::size_t k) {
  return list.data()[k + 1].begin;
}

/// Index of the last window of a list that begins at t or before. Nearly all searches end at the
/// first window or at one of the last two; the others are binary. The list must not be empty.
inline std::size_t place_of(std::span<const ListedWindow> list, double t) {
  const std::size_t last = list.size() - 1;
  const std::size_t likely = end_of(list, 0) > t ? 0 : last - (list[last].begin > t ? 1 : 0);
  if (list[likely].begin <= t) [[likely]] {
    return likely;
  }
  const auto next = std::ranges::upper_bound(list, t, {}, &ListedWindow::begin);
  return static_cast<std::size_t>(next - list.begin()) - 1;
}

/// Lists by the half-edges that name them. A list is empty until it is opened. Its windows then
/// partition the edge, until the list is closed; it then stays empty.
class EdgeLists {
 public:
  explicit EdgeLists(Index half_edges) : lists_(half_edges) {}

  void clear() {
    std::fill(lists_.begin(), lists_.end(), List{});
    segments_.clear();
  }

  std::span<const ListedWindow> operator[](Index edge) const {
    return {lists_[edge].windows, lists_[edge].size};
  }
  /// Upper bound of the names of edges, whether reached or not.
  Index edge_bound() const { return static_cast<Index>(lists_.size()); }

  bool is_closed(Index edge) const { return lists_[edge].capacity == kClosed; }

  /// Gives an empty list its first window, over the whole edge.
  void open(Index edge, double length, Index window) {
    const std::uint32_t capacity = Segments::capacity_for(kFirstRoom), room = capacity / 2 - 1;
    List& list = lists_[edge] = {segments_.take(capacity) + room, 1, room, capacity};
    list.windows[0] = {0, window};
    list.windows[1] = {length, kNone};
  }

  /// Replaces windows [first, last) of an edge's list by windows stored elsewhere. Of the parts
  /// before and behind them, the shorter one moves.
  void replace(Index edge, std::size_t first, std::size_t last, std::span<const ListedWindow> by) {
    List& list = lists_[edge];
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
    List& list = lists_[edge];
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

  struct List {
    ListedWindow* windows = nullptr;
    std::uint32_t size = 0;  // without the edge's end, which follows
    std::uint32_t room_before = 0, capacity = 0;
  };

  // A few windows, for which a call takes longer.
  static void move(const ListedWindow* from, ListedWindow* to, std::size_t windows) {
    if (to < from) {
      for (std::size_t k = 0; k < windows; ++k) to[k] = from[k];
    } else {
      for (std::size_t k = windows; k-- > 0;) to[k] = from[k];
    }
  }

  // Moves a list into an array with room for at least `more` windows at both ends, and for half as
  // many windows as it has.
  // @param used what the list holds, with the edge's end
  void move_to_larger(List& list, std::size_t used, std::size_t more) {
    const std::uint32_t capacity =
        Segments::capacity_for(static_cast<std::uint32_t>(used + used / 2 + 2 * more + 2));
    const std::uint32_t room = (capacity - static_cast<std::uint32_t>(used)) / 2;
    ListedWindow* const larger = segments_.take(capacity);
    std::copy(list.windows, list.windows + used, larger + room);
    segments_.give_back(list.windows - list.room_before, list.capacity);
    list = {larger + room, list.size, room, capacity};
  }

  std::vector<List> lists_;
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
