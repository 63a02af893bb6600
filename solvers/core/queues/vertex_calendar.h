// A calendar queue (bucket_ring.h) of vertices whose distances may decrease while they wait: the
// order of VertexHeap but for the vertices of one bucket, which are first in, first out.
//
// A vertex that moves forward leaves its old entry behind: an entry counts only in the bucket that
// is noted for its vertex. That spares the links by which an entry would be found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/queues/bucket_ring.h"

namespace geodesic {

/// Bucket n lies in slot n modulo kSlots, so that keys may be farther apart than the slots reach.
/// Popping passes over empty buckets one by one, and over more than a lap of them at once.
class VertexCalendar {
 public:
  /// @param vertices number of vertices; ids run from 0 to vertices - 1
  /// @param width keys covered by one bucket, in the keys' unit; not positive: all are in one
  VertexCalendar(Index vertices, double width)
      : numbers_(width), slots_(kSlots), bucket_(vertices, kAbsent) {}

  bool empty() const { return size_ == 0; }

  /// No vertex that waits has a smaller key.
  double least_key() const { return numbers_.least_key(current_); }

  /// The same, where the first bucket begins that holds a vertex. Must not be empty.
  double first_key() {
    seek();
    return least_key();
  }

  void clear() {
    for (std::vector<Index>& slot : slots_) {
      for (const Index v : slot) bucket_[v] = kAbsent;
      slot.clear();
    }
    size_ = 0;
    move_to(0);
    popped_ = 0;
  }

  /// Inserts v, or moves it forward when it is there in a later bucket. A key that lies behind what
  /// was popped last joins the bucket of that.
  void push_or_decrease(Index v, double key) {
    const std::int32_t bucket = std::max(
        static_cast<std::int32_t>(std::min(numbers_.of(key), std::int64_t{kLast})), popped_);
    if (bucket_[v] == kAbsent) {
      ++size_;
    } else if (bucket >= bucket_[v]) {
      return;
    }
    bucket_[v] = bucket;
    slots_[slot_of(bucket)].push_back(v);
    if (bucket < current_) move_to(bucket);
  }

  /// A vertex that is likely to be popped next, for its data to be prefetched; kNone when none is
  /// known.
  Index upcoming() const {
    const std::vector<Index>& slot = slots_[slot_of(current_)];
    return at_ < slot.size() ? slot[at_] : kNone;
  }

  /// Removes and returns the vertex that has been longest in the first bucket that holds any. Must
  /// not be empty.
  Index pop() {
    const Index v = seek();
    popped_ = current_;
    bucket_[v] = kAbsent;
    ++at_;
    --size_;
    return v;
  }

 private:
  static constexpr std::size_t kSlots = 1 << 8;  // a power of two
  static constexpr std::int32_t kAbsent = -1;
  /// What is farther shares the last bucket.
  static constexpr std::int32_t kLast = INT32_MAX;

  static std::size_t slot_of(std::int32_t bucket) {
    return static_cast<std::size_t>(bucket) % kSlots;
  }

  /// Goes on with the first entry of a bucket.
  void move_to(std::int32_t bucket) {
    current_ = bucket;
    at_ = later_ = 0;
  }

  /// Moves on to the first bucket that holds a vertex. @return the one that is longest in it
  Index seek() {
    std::size_t passed = 0;
    for (;;) {
      std::vector<Index>& slot = slots_[slot_of(current_)];
      for (; at_ < slot.size(); ++at_) {
        const Index v = slot[at_];
        if (bucket_[v] == current_) return v;
        const bool is_of_later_lap =
            bucket_[v] > current_ && slot_of(bucket_[v]) == slot_of(current_);
        if (is_of_later_lap) slot[later_++] = v;
      }
      slot.resize(later_);
      move_to(++passed < kSlots ? current_ + 1 : first_bucket());
    }
  }

  std::int32_t first_bucket() const {
    std::int32_t least = kLast;
    for (const std::vector<Index>& slot : slots_) {
      for (const Index v : slot) {
        if (bucket_[v] != kAbsent) least = std::min(least, bucket_[v]);
      }
    }
    return least;
  }

  BucketNumbers numbers_;
  std::vector<std::vector<Index>> slots_;
  std::vector<std::int32_t> bucket_;  // of each vertex, kAbsent when it does not wait
  std::int32_t current_ = 0;          // no vertex waits in an earlier bucket
  std::int32_t popped_ = 0;           // bucket popped from last
  std::size_t at_ = 0;                // of the current slot: what is in front has been passed over,
  std::size_t later_ = 0;             // but for so many entries of later laps
  std::size_t size_ = 0;
};

}  // namespace geodesic
