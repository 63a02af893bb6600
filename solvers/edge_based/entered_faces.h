// Which faces the wavefront has entered, on which half-edges something waits, and which of them
// cross next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic::edge_based {

/// A face is entered when one of its vertices is popped. What waits on its half-edges crosses then,
/// first in, first out, and what lands on them later crosses after that.
class EnteredFaces {
 public:
  explicit EnteredFaces(Index faces) : faces_(faces) {}

  void clear() {
    std::ranges::fill(faces_, std::uint8_t{0});
    waiting_ = 0;
  }

  bool has_entered(Index h) const { return (faces_[h / 3] & kEntered) != 0; }

  /// Something has landed on h, where `has_landed`.
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

  /// What waits on h crosses next, though its face has not been entered.
  void enqueue(Index h) {
    make_room(1);
    push_if(true, h);
  }

  /// Calls cross(h) for each half-edge that crosses next, also for those that are added meanwhile.
  template <class Cross>
  void cross_all(const Cross& cross) {
    for (std::size_t i = 0; i < waiting_; ++i) {
      const Index h = fifo_[i];
      faces_[h / 3] &= static_cast<std::uint8_t>(~(1u << h % 3));
      cross(h);
    }
    waiting_ = 0;
  }

  /// Calls visit(h) for each half-edge of faces from `first` on, none of which has been entered,
  /// on which something has landed since the last call.
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
  // Bit k of a face says that something waits on its half-edge k, this one that it is entered. Then
  // what waits is in the FIFO.
  static constexpr unsigned kEntered = 1u << 3;

  void make_room(std::size_t more) {
    if (waiting_ + more > fifo_.size()) [[unlikely]] {
      fifo_.resize(2 * waiting_ + more + 256);
    }
  }
  // Without a branch, which would be mispredicted often. There must be room.
  void push_if(bool wanted, Index h) {
    fifo_[waiting_] = h;
    waiting_ += wanted;
  }

  std::vector<std::uint8_t> faces_;
  std::vector<Index> fifo_;
  std::size_t waiting_ = 0;  // in the FIFO; the rest is room
};

}  // namespace geodesic::edge_based
