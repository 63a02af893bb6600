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

/// One bit per window of a list, kMostLanes bits per byte.
class Marks {
 public:
  void reserve(std::size_t windows) {
    if (groups_.size() <= windows / kMostLanes) groups_.resize(2 * (windows / kMostLanes + 1));
  }

  bool operator[](std::size_t i) const {
    return (groups_[i / kMostLanes] >> (i % kMostLanes) & 1) != 0;
  }
  void clear(std::size_t i) {
    groups_[i / kMostLanes] &= static_cast<std::uint8_t>(~(1u << (i % kMostLanes)));
  }

  /// Copies the marks of the first `windows` windows of another list.
  void copy(const Marks& from, std::size_t windows) {
    reserve(windows);
    std::copy_n(from.groups_.begin(), windows / kMostLanes + 1, groups_.begin());
  }

  /// The first marked window from `i` on, among `count` windows; `count` if there is none.
  std::size_t next(std::size_t i, std::size_t count) const {
    if (i >= count) return count;
    std::size_t group = i / kMostLanes;
    unsigned marks = groups_[group] & (~0u << (i % kMostLanes));
    while (marks == 0) {
      if (++group * kMostLanes >= count) return count;
      marks = groups_[group];
    }
    return group * kMostLanes + static_cast<std::size_t>(std::countr_zero(marks));
  }

  /// The bytes of the marks, for kernels.
  std::uint8_t* groups() { return groups_.data(); }
  const std::uint8_t* groups() const { return groups_.data(); }

 private:
  std::vector<std::uint8_t> groups_;
};

/// Arrays of equal capacity. Vector instructions may read and write up to kMostLanes doubles behind
/// the last window.
class Batch {
 public:
  /// @param fields number of fields of a window (Field)
  explicit Batch(unsigned fields) : fields_(fields) {}

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
