// Insertion of a new window among the windows of an edge: computes the owners of all parts.
//
// This is MMP's trimming (Surazhsky et al. 2005, section 3.3), without side effects; the result is
// a partition again. Parts narrower than kWindowWidth of the edge are never created: they stay with
// the window from which they would be cut.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solvers/mmp/edge_window.h"
#include "solvers/mmp/intersect.h"

namespace geodesic::mmp {

/// The event of a challenger's parts until they get one or turn out not to wait.
inline constexpr Index kNoEventYet = kNone - 1;

/// The replacement of windows [first, last) of the list: pieces of those windows and parts of the
/// challenger. Other windows of the list do not change.
template <class W>
class Overlay {
 public:
  std::size_t first = 0, last = 0;
  double end = 0;  ///< of the last piece

  std::span<W> pieces() { return {room_.data(), count_}; }
  double piece_end(std::size_t k) const { return k + 1 < count_ ? room_[k + 1].begin : end; }

  /// Removes all pieces; at most `windows` windows will be overlaid next.
  void start(std::size_t windows) {
    count_ = 0;
    owner_ = nullptr;
    if (room_.size() < kMostPieces * windows) room_.resize(kMostPieces * windows);
  }

  /// Gives the part from `begin` on to `owner`; the part before may have the same owner.
  void add(double begin, const W* owner) {
    if (owner_ == owner) return;
    owner_ = owner;
    room_[count_] = *owner;
    room_[count_++].begin = begin;
  }

 private:
  // For one window: the part before the challenger, three within it, and one after it.
  static constexpr std::size_t kMostPieces = 5;

  std::vector<W> room_;
  std::size_t count_ = 0;
  const W* owner_ = nullptr;  // of the last piece
};

/// End of window i of an edge's list.
template <class W>
double end_of(std::span<W> list, std::size_t i, double length) {
  return i + 1 < list.size() ? list[i + 1].begin : length;
}

/// Index of the last window of a non-empty list that begins at `position` or before; there must be
/// one. With branches: the processor guesses and loads the next window before the last arrives.
template <class W>
std::size_t window_at(std::span<W> list, double position) {
  const auto begins_behind = [](double t, const W& w) { return t < w.begin; };
  const auto next = std::upper_bound(list.begin() + 1, list.end(), position, begins_behind);
  return static_cast<std::size_t>(next - list.begin()) - 1;
}

/// @param list the edge's windows, a partition of [0, length]
/// @param challenger in the same frame, any sign of y, its event is kNoEventYet
/// @param end where the challenger ends
/// @param sigmas by number of source
/// @param result overwritten; valid if the challenger got a part
/// @return whether the challenger got a part
template <class W>
bool overlay(std::span<const W> list, double length, const W& challenger, double end,
             std::span<const double> sigmas, Overlay<W>& result) {
  const double narrowest = kWindowWidth * length;
  const Window rival = challenger.geometry(end, sigmas[challenger.source]);
  std::size_t i = window_at(list, challenger.begin);
  bool won = false;
  for (; i < list.size() && list[i].begin < end; ++i) {
    const W& old = list[i];
    const double old_end = end_of(list, i, length);
    double from = std::max(old.begin, challenger.begin), to = std::min(old_end, end);
    if (from - old.begin < narrowest) from = old.begin;
    if (old_end - to < narrowest) to = old_end;
    if (!(to - from > narrowest)) continue;
    Division division{.challenger_first = true};
    if (!old.is_gap()) {
      division = divide(rival, old.geometry(old_end, sigmas[old.source]), from, to, narrowest);
      if (!division.challenger_first && division.cuts == 0) continue;
    }
    if (!won) {
      result.start(list.size() - i);
      result.first = result.last = i;
      won = true;
    }
    for (; result.last < i; ++result.last) result.add(list[result.last].begin, &list[result.last]);
    if (from > old.begin) result.add(old.begin, &old);
    bool challengers = division.challenger_first;
    result.add(from, challengers ? &challenger : &old);
    for (int k = 0; k < division.cuts; ++k) {
      challengers = !challengers;
      result.add(division.at[k], challengers ? &challenger : &old);
    }
    if (to < old_end) result.add(to, &old);
    result.last = i + 1;
    result.end = old_end;
  }
  return won;
}

}  // namespace geodesic::mmp
