// A calendar queue (bucket_ring.h) of vertices whose distances may decrease while they wait. The
// order is that of VertexHeap, except that vertices of one bucket are first in, first out.
//
// A vertex that moves forward leaves its old entry behind. The valid entry is in the earliest
// bucket and is met first; the vertex then no longer waits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/pool.h"
#include "solvers/core/queues/bucket_ring.h"

namespace geodesic {

/// The keys of a vertex only decrease until the queue is cleared, even after it was popped.
///
/// Bucket n lies in slot n modulo kSlots, so keys may be farther apart than the slots reach.
/// Popping skips empty buckets one by one, and more than a lap of them at once.
class VertexCalendar {
 public:
  /// @param vertices number of vertices; ids run from 0 to vertices - 1
  /// @param width keys covered by one bucket, in the keys' unit; 0: all are in one
  VertexCalendar(Index vertices, double width)
      : numbers_(width), slots_(kSlots), marks_(vertices, kAbsent) {}

  bool empty() const { return size_ == 0; }

  /// No waiting vertex has a smaller key.
  double least_key() const { return numbers_.least_key(current_); }

  /// As least_key, at the first bucket that holds a vertex. Must not be empty.
  double first_key() {
    seek();
    return least_key();
  }

  void clear() {
    slots_[slot_of(current_)].append(nodes_, std::exchange(now_, {}));
    for_each_entry([&](const Entry& entry) { marks_[entry.vertex] = kAbsent; });
    std::ranges::fill(slots_, Fifo{});
    nodes_.clear();
    size_ = 0;
    current_ = popped_ = farthest_ = 0;
  }

  /// Inserts v, or moves it forward. A key below the bucket popped last joins that bucket.
  void push_or_decrease(Index v, double key) {
    const std::int32_t bucket = std::max(
        static_cast<std::int32_t>(std::min(numbers_.of(key), std::int64_t{kLast})), popped_);
    std::uint8_t& mark = marks_[v];
    const std::uint8_t waits_here = kWaits | static_cast<std::uint8_t>(slot_of(bucket));
    if (mark == kAbsent) {
      ++size_;
    } else if (mark == waits_here && farthest_ - bucket < kSlots) {
      return;
    }
    mark = waits_here;
    farthest_ = std::max(farthest_, bucket);
    if (bucket < current_) move_to(bucket);
    (bucket == current_ ? now_ : slots_[slot_of(bucket)]).push(nodes_, Entry{v, bucket});
  }

  /// A vertex that is likely to be popped next, so that its data can be prefetched; kNone when none
  /// is known.
  Index upcoming() const { return now_.empty() ? kNone : nodes_[now_.first].item.vertex; }

  /// Removes and returns the vertex that has waited longest in the first non-empty bucket. Must not
  /// be empty.
  Index pop() {
    const Index v = seek();
    take_first(now_);
    popped_ = current_;
    marks_[v] = kAbsent;
    --size_;
    return v;
  }

 private:
  struct Entry {
    Index vertex;
    std::int32_t bucket;
  };

  // A mark is the slot in which a vertex waits, plus kWaits.
  static constexpr std::uint8_t kAbsent = 0, kWaits = 1u << 7;
  static constexpr std::int32_t kSlots = kWaits;
  /// Buckets beyond this one share it.
  static constexpr std::int32_t kLast = INT32_MAX;

  static std::size_t slot_of(std::int32_t bucket) {
    return static_cast<std::size_t>(bucket % kSlots);
  }

  Entry take_first(Fifo& list) {
    const Index first = list.first;
    list.drop_first(nodes_);
    return nodes_.take(first).item;
  }

  /// Makes a bucket the current one.
  void move_to(std::int32_t bucket) {
    slots_[slot_of(current_)].append(nodes_, std::exchange(now_, {}));
    current_ = bucket;
    Fifo& slot = slots_[slot_of(bucket)];
    Fifo all = std::exchange(slot, {});
    if (farthest_ - bucket < kSlots) {
      now_ = all;
      return;
    }
    while (!all.empty()) {
      const Entry entry = take_first(all);
      (entry.bucket == bucket ? now_ : slot).push(nodes_, entry);
    }
  }

  /// Moves on to the first bucket that holds a vertex. @return the one that has waited longest
  Index seek() {
    std::int32_t passed = 0;
    for (;;) {
      for (; !now_.empty(); take_first(now_)) {
        const Index v = nodes_[now_.first].item.vertex;
        if (marks_[v] != kAbsent) return v;
      }
      move_to(++passed < kSlots ? current_ + 1 : first_bucket());
    }
  }

  std::int32_t first_bucket() const {
    std::int32_t first = kLast;
    for_each_entry([&](const Entry& entry) {
      if (marks_[entry.vertex] != kAbsent) first = std::min(first, entry.bucket);
    });
    return first;
  }

  /// Visits the entries of all slots.
  template <class Visit>
  void for_each_entry(const Visit& visit) const {
    for (const Fifo& slot : slots_) {
      Index n = slot.first;
      for (std::uint32_t left = slot.count; left > 0; --left, n = nodes_[n].next) {
        visit(nodes_[n].item);
      }
    }
  }

  BucketNumbers numbers_;
  std::vector<Fifo> slots_;
  Pool<BucketNode<Entry>> nodes_;
  Fifo now_;  // what is left of the current bucket; its slot then has entries of later laps only
  std::vector<std::uint8_t> marks_;  // by vertex
  std::int32_t current_ = 0;         // no vertex waits in an earlier bucket
  std::int32_t popped_ = 0;          // bucket popped from last
  std::int32_t farthest_ = 0;        // no entry is in a later bucket
  std::size_t size_ = 0;
};

}  // namespace geodesic
