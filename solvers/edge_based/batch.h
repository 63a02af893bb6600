// The windows of one list while they cross a face: a structure of arrays.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "solvers/core/window.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// Arrays of equal room; vectors may read and write up to kLaneRoom doubles behind the last window.
class Batch {
 public:
  std::size_t count = 0;

  double* array(unsigned field) { return arrays_.get() + field * room_; }
  const double* array(unsigned field) const { return arrays_.get() + field * room_; }

  /// Room for this many windows, keeping what is there.
  void reserve(std::size_t windows);

  Window window(std::size_t i) const { return window_of(*this, i); }
  void set_interval(std::size_t i, const Window& w) {
    array(kBegin)[i] = w.begin;
    array(kEnd)[i] = w.end;
  }
  /// Takes a window out without moving the others: no line leads through its empty interval, so
  /// that it lies on neither side of any apex.
  void strike_out(std::size_t i) {
    array(kBegin)[i] = kInfinity;
    array(kEnd)[i] = -kInfinity;
  }
  bool is_struck_out(std::size_t i) const { return array(kBegin)[i] == kInfinity; }

 private:
  static constexpr unsigned kArrays = kRoot + 1;  // one a Field
  std::unique_ptr<double[]> arrays_;
  std::size_t room_ = 0;
};

inline void Batch::reserve(std::size_t windows) {
  if (windows + kLaneRoom <= room_) return;
  const std::size_t room = 2 * (windows + 2 * kLaneRoom) / kLaneRoom * kLaneRoom;
  auto larger = std::make_unique<double[]>(kArrays * room);
  for (unsigned f = 0; f < kArrays; ++f) {
    for (std::size_t i = 0; i < count; ++i) larger[f * room + i] = array(f)[i];
  }
  arrays_ = std::move(larger);
  room_ = room;
}

}  // namespace geodesic::edge_based
