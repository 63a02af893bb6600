// The windows of one list while they cross a face, as a structure of arrays.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solvers/core/window.h"
#include "solvers/edge_based/trim.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// One bit per window of a list, one byte per vector of windows.
class Marks {
 public:
  /// @param lanes size of vectors, a power of 2
  explicit Marks(std::size_t lanes) : lane_bits_(static_cast<unsigned>(std::countr_zero(lanes))) {}

  void reserve(std::size_t windows) {
    if (groups_.size() <= group_of(windows)) groups_.resize(2 * (group_of(windows) + 1));
  }

  bool operator[](std::size_t i) const { return (groups_[group_of(i)] >> lane_of(i) & 1) != 0; }
  void clear(std::size_t i) {
    groups_[group_of(i)] &= static_cast<std::uint8_t>(~(1u << lane_of(i)));
  }

  /// Copies the marks of the first `windows` windows of another list.
  void copy(const Marks& from, std::size_t windows) {
    reserve(windows);
    std::copy_n(from.groups_.begin(), group_of(windows) + 1, groups_.begin());
  }

  /// The first marked window from `i` on, among `count` windows; `count` if there is none.
  std::size_t next(std::size_t i, std::size_t count) const {
    if (i >= count) return count;
    std::size_t group = group_of(i);
    unsigned marks = groups_[group] & (~0u << lane_of(i));
    while (marks == 0) {
      if (++group << lane_bits_ >= count) return count;
      marks = groups_[group];
    }
    return (group << lane_bits_) + static_cast<std::size_t>(std::countr_zero(marks));
  }

  /// The bytes of the marks, for kernels.
  std::uint8_t* groups() { return groups_.data(); }
  const std::uint8_t* groups() const { return groups_.data(); }

 private:
  std::size_t group_of(std::size_t i) const { return i >> lane_bits_; }
  std::size_t lane_of(std::size_t i) const { return i & ((std::size_t{1} << lane_bits_) - 1); }

  unsigned lane_bits_;
  std::vector<std::uint8_t> groups_;
};

/// Arrays of equal capacity. Vector instructions may read and write up to kMostLanes doubles behind
/// the last window.
class Batch {
 public:
  /// @param fields number of fields of a window (Field)
  /// @param lanes of the kernels
  Batch(unsigned fields, std::size_t lanes)
      : passes_left(lanes), passes_right(lanes), contested(lanes), fields_(fields) {}

  std::size_t count = 0;
  /// Set by the kernels: the sides on which a window's lines pass the apex. Both are marked if
  /// lines pass through the apex.
  Marks passes_left, passes_right;
  /// Windows that sides_kept (split.h) decides.
  Marks contested;

  unsigned fields() const { return fields_; }
  double* array(unsigned field) { return arrays_.get() + field * room_; }
  const double* array(unsigned field) const { return arrays_.get() + field * room_; }

  /// Makes room for this many windows and keeps the existing ones.
  void reserve(std::size_t windows);

  Window window(std::size_t i) const { return window_of(*this, i); }
  void set_interval(std::size_t i, const Window& w) {
    array(kBegin)[i] = w.begin;
    array(kEnd)[i] = w.end;
  }
  /// Removes a window without moving the others: no line passes its empty interval, so it lies on
  /// neither side of any apex.
  void strike_out(std::size_t i) {
    array(kBegin)[i] = kInfinity;
    array(kEnd)[i] = -kInfinity;
  }
  /// Stores the rest of a window of an edge of this length, or strikes it out if nothing is left.
  /// @return false when it is struck out
  bool put_back(std::size_t i, const Window& w, double length) {
    const bool remains = !is_void(w, length);
    if (remains) {
      set_interval(i, w);
    } else {
      strike_out(i);
    }
    return remains;
  }
  bool is_struck_out(std::size_t i) const { return array(kBegin)[i] == kInfinity; }

 private:
  unsigned fields_;
  std::unique_ptr<double[]> arrays_;
  std::size_t room_ = 0;
};

inline void Batch::reserve(std::size_t windows) {
  if (windows + kMostLanes <= room_) return;
  const std::size_t room = 2 * (windows + 2 * kMostLanes) / kMostLanes * kMostLanes;
  auto larger = std::make_unique<double[]>(fields_ * room);
  for (unsigned f = 0; f < fields_; ++f) {
    for (std::size_t i = 0; i < count; ++i) larger[f * room + i] = array(f)[i];
  }
  arrays_ = std::move(larger);
  room_ = room;
  for (Marks* marks : {&passes_left, &passes_right, &contested}) marks->reserve(room);
}

}  // namespace geodesic::edge_based
