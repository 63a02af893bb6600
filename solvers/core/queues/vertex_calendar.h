// A calendar queue (bucket_ring.h) of vertices whose distances may decrease while they wait: the
// order of VertexHeap but for the vertices of one bucket, which are first in, first out.
//
// A vertex is in it once and must be found to be moved, so that buckets are doubly linked through
// the vertices themselves; they have no nodes of a pool.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/queues/bucket_ring.h"

namespace geodesic {

/// Bucket n lies in slot n modulo kSlots, and n is kept for each vertex, so that
/// keys may be farther apart than the slots reach. Popping passes over empty buckets one by one,
/// and over more than a lap of them at once.
class VertexCalendar {
 public:
  /// @param vertices number of vertices; ids run from 0 to vertices - 1
  /// @param width keys covered by one bucket, in the keys' unit; not positive: all are in one
  VertexCalendar(Index vertices, double width)
      : numbers_(width), vertices_(vertices), bucket_(vertices, kAbsent) {
    next_.resize(vertices + kSlots);
    previous_.resize(vertices + kSlots);
    for (std::size_t slot = 0; slot < kSlots; ++slot) make_empty(slot);
  }

  bool empty() const { return size_ == 0; }

  /// No vertex that waits has a smaller key.
  double least_key() const { return numbers_.least_key(current_); }

  /// The same, where the first bucket begins that holds a vertex. Must not be empty.
  double first_key() {
    seek();
    return least_key();
  }

  void clear() {
    for (std::size_t slot = 0; slot < kSlots && size_ > 0; ++slot) {
      for (Index v = first(slot); v < vertices_; v = next_[v]) {
        bucket_[v] = kAbsent;
        --size_;
      }
      make_empty(slot);
    }
    current_ = popped_ = 0;
  }

  /// Inserts v, or moves it forward when it is there in a later bucket. A key that lies behind what
  /// was popped last joins the bucket of that.
  void push_or_decrease(Index v, double key) {
    const std::int64_t bucket = std::max(numbers_.of(key), popped_);
    if (bucket_[v] == kAbsent) {
      ++size_;
    } else if (bucket < bucket_[v]) {
      unlink(v);
    } else {
      return;
    }
    current_ = std::min(current_, bucket);
    bucket_[v] = bucket;
    append(slot_of(bucket), v);
  }

  /// A vertex that is likely to be popped next, for its data to be prefetched; kNone when none is
  /// known.
  Index upcoming() const {
    const Index v = first(slot_of(current_));
    return v < vertices_ ? v : kNone;
  }

  /// Removes and returns the vertex that has been longest in the first bucket that holds any. Must
  /// not be empty.
  Index pop() {
    const Index v = seek();
    popped_ = current_;
    unlink(v);
    bucket_[v] = kAbsent;
    --size_;
    return v;
  }

 private:
  static constexpr std::size_t kSlots = 1 << 10;  // a power of two
  static constexpr std::int64_t kAbsent = -1;

  static std::size_t slot_of(std::int64_t bucket) {
    return static_cast<std::size_t>(bucket) % kSlots;
  }

  // A slot is a ring: of its vertices, and of an end that has a number behind those of vertices.
  Index end(std::size_t slot) const { return vertices_ + static_cast<Index>(slot); }
  Index first(std::size_t slot) const { return next_[end(slot)]; }

  void make_empty(std::size_t slot) { next_[end(slot)] = previous_[end(slot)] = end(slot); }

  void append(std::size_t slot, Index v) {
    const Index last = previous_[end(slot)];
    next_[last] = v;
    previous_[v] = last;
    next_[v] = end(slot);
    previous_[end(slot)] = v;
  }

  void unlink(Index v) {
    next_[previous_[v]] = next_[v];
    previous_[next_[v]] = previous_[v];
  }

  /// Moves on to the first bucket that holds a vertex. @return the one that is longest in it
  Index seek() {
    std::size_t passed = 0;
    for (;;) {
      for (Index v = first(slot_of(current_)); v < vertices_; v = next_[v]) {
        if (bucket_[v] == current_) return v;
      }
      ++current_;
      if (++passed == kSlots) current_ = first_bucket();
    }
  }

  std::int64_t first_bucket() const {
    std::int64_t least = INT64_MAX;
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      for (Index v = first(slot); v < vertices_; v = next_[v]) least = std::min(least, bucket_[v]);
    }
    return least;
  }

  BucketNumbers numbers_;
  Index vertices_;
  std::vector<std::int64_t> bucket_;  // of each vertex, kAbsent when it does not wait
  std::vector<Index> next_, previous_;
  std::int64_t current_ = 0;  // no vertex waits in an earlier bucket
  std::int64_t popped_ = 0;   // bucket popped from last
  std::size_t size_ = 0;
};

}  // namespace geodesic
