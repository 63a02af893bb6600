// The faces that the wavefront has entered, the half-edges on which windows wait, and those whose
// windows cross next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic::edge_based {

/// A face is entered when one of its vertices is popped. The windows that wait on its half-edges
/// then cross it, first in, first out; windows that land later cross it afterwards.
class EnteredFaces {
 public:
  explicit EnteredFaces(Index faces) : faces_(faces) {}

  void clear() {
    std::ranges::fill(faces_, std::uint8_t{0});
    waiting_ = 0;
  }

  bool has_entered(Index h) const { return (faces_[h / 3] & kEntered) != 0; }

  /// Call when windows have landed on h; without effect if `has_landed` is false.
  void land(Index h, bool has_landed) {
    std::uint8_t& face = faces_[h / 3];
    const unsigned before = face, side = h % 3;
    face = static_cast<std::uint8_t>(before | unsigned{has_landed} << side);
    make_room(1);
    push_if(has_landed & (before >= kEntered) & ((before >> side & 1) == 0), h);
  }

  void enter(Index f) {
    const unsigned before = faces_[f];
    faces_[f] = static_cast<std::uint8_t>(before | kEntered);
    const unsigned crosses = before >= kEntered ? 0 : before;
    make_room(3);
    push_if(crosses & 1, 3 * f);
    push_if(crosses >> 1 & 1, 3 * f + 1);
    push_if(crosses >> 2 & 1, 3 * f + 2);
  }

  /// The windows on h cross next, though its face has not been entered.
  void enqueue(Index h) {
    make_room(1);
    push_if(true, h);
  }

  /// Calls cross(h) for each half-edge whose windows cross next, including those added meanwhile.
  template <class Cross>
  void cross_all(const Cross& cross) {
    for (std::size_t i = 0; i < waiting_; ++i) {
      const Index h = fifo_[i];
      faces_[h / 3] &= static_cast<std::uint8_t>(~(1u << h % 3));
      cross(h);
    }
    waiting_ = 0;
  }

  /// Calls visit(h) for each half-edge, in faces from `first` on, on which windows have landed
  /// since the last call. None of these faces may have been entered.
  template <class Visit>
  void take_landings(Index first, const Visit& visit) {
    for (Index f = first; f < faces_.size(); ++f) {
      if (faces_[f] == 0) continue;
      for (Index k = 0; k < 3; ++k) {
        if ((faces_[f] >> k & 1) != 0) visit(3 * f + k);
      }
      faces_[f] = 0;
    }
  }

 private:
  // Bit k of a face means that windows wait on its half-edge k, this bit that the face is entered.
  // Half-edges of an entered face wait in the FIFO.
  static constexpr unsigned kEntered = 1u << 3;

  void make_room(std::size_t more) {
    if (waiting_ + more > fifo_.size()) [[unlikely]] {
      fifo_.resize(2 * waiting_ + more + 256);
    }
  }
  // Without a branch, which would often be mispredicted. There must be room.
  void push_if(bool wanted, Index h) {
    fifo_[waiting_] = h;
    waiting_ += wanted;
  }

  std::vector<std::uint8_t> faces_;
  std::vector<Index> fifo_;
  std::size_t waiting_ = 0;  // used part of the FIFO
};

}  // namespace geodesic::edge_based
