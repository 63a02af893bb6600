// Laying a new window over the windows of an edge: who owns which part afterwards.
//
// This is MMP's trimming (Surazhsky et al. 2005, section 3.3) as a question without side effects;
// the answer is a partition again. Parts narrower than kWindowWidth of the edge are never created:
// they stay with the window they would be cut from.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solvers/mmp/edge_window.h"
#include "solvers/mmp/intersect.h"

namespace geodesic::mmp {

/// A part of the edge, up to the next piece's begin, and the window it belongs to.
template <class W>
struct Piece {
  double begin;
  const W* owner;  ///< in the edge's list; null for the challenger
};

/// What takes the place of windows [first, last) of the list.
template <class W>
struct Overlay {
  std::size_t first = 0, last = 0;
  double end = 0;  ///< of the last piece
  std::vector<Piece<W>> pieces;

  void add(double begin, const W* owner) {
    if (pieces.empty() || pieces.back().owner != owner) pieces.push_back({begin, owner});
  }
  double piece_end(std::size_t k) const {
    return k + 1 < pieces.size() ? pieces[k + 1].begin : end;
  }
};

/// Where window i of an edge's list ends.
template <class W>
double end_of(std::span<W> list, std::size_t i, double length) {
  return i + 1 < list.size() ? list[i + 1].begin : length;
}

/// Index of the last window of a non-empty list for which `begins_before` holds; true for a front
/// part of the list, of one window at least. Branches on nothing: the outcomes are unpredictable.
template <class W, class Predicate>
std::size_t window_at(std::span<W> list, Predicate begins_before) {
  std::size_t at = 0;
  for (std::size_t left = list.size(); left > 1;) {
    const std::size_t half = left / 2;
    at += begins_before(list[at + half]) ? half : 0;
    left -= half;
  }
  return at;
}

/// @param list the edge's windows, a partition of [0, length]
/// @param challenger in the same frame, any sign of y
/// @param result overwritten; meaningful when the challenger got a part
/// @return whether it did
template <class W>
bool overlay(std::span<const W> list, double length, const Window& challenger, Overlay<W>& result) {
  const double narrowest = kWindowWidth * length;
  bool won = false;
  std::size_t i = window_at(list, [&](const W& w) { return w.begin <= challenger.begin; });
  result.pieces.clear();
  result.first = i;
  for (; i < list.size() && list[i].begin < challenger.end; ++i) {
    const W& old = list[i];
    const double end = end_of(list, i, length);
    double from = std::max(old.begin, challenger.begin), to = std::min(end, challenger.end);
    if (from - old.begin < narrowest) from = old.begin;
    if (end - to < narrowest) to = end;
    Division division;
    if (to - from > narrowest) {
      division = old.is_gap() ? Division{.challenger_first = true}
                              : divide(challenger, old.geometry(end), from, to, narrowest);
    }
    won |= division.challenger_first || division.cuts > 0;
    if (from > old.begin) result.add(old.begin, &old);
    bool challengers = division.challenger_first;
    result.add(from, challengers ? nullptr : &old);
    for (int k = 0; k < division.cuts; ++k) {
      challengers = !challengers;
      result.add(division.at[k], challengers ? nullptr : &old);
    }
    if (to < end) result.add(to, &old);
    result.end = end;
  }
  result.last = i;
  return won;
}

}  // namespace geodesic::mmp
