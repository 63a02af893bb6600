// Buckets processed in phases: the order of fast wavefront propagation.
//
// Xu, Wang, Liu, Liu, He 2015, "Fast wavefront propagation (FWP) for computing exact geodesic
// distances on meshes". Any order of propagation is correct, so windows are only sorted into
// buckets by floor(key / width). A phase takes the first buckets that together hold at least K
// windows, first in first out inside a bucket; windows created during a phase wait for the next
// one. K adapts: it grows after a phase whose children mostly lie above its upper bound, and
// shrinks otherwise. The authors' later programs bound K on both sides. Without an upper bound a
// phase grows to nearly the whole wavefront, which then is no longer sorted.
//
// The buckets are a ring (bucket_ring.h) that starts at the running phase. Keys beyond its far end
// (another source's initial distance, a very long edge) wait in a heap until the ring reaches them.
// Memory and time thus depend on the number of items, not on the range of their keys.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "solvers/core/queues/bucket_ring.h"
#include "solvers/core/queues/key_heap.h"

namespace geodesic {

/// The queue of FWP-MMP and FWP-CH. Items are small and trivially copyable.
template <class Item>
class BucketQueue {
 public:
  /// @param width keys covered by one bucket, in the keys' unit; published_bucket_width is the
  ///        usual choice. If it is 0, one bucket takes everything.
  explicit BucketQueue(double width) : numbers_(width), ring_(kRing) {}

  bool empty() const { return phase_.empty() && ring_.empty() && far_.empty(); }
  std::size_t size() const { return phase_.count + ring_.items() + far_.size(); }

  void clear() {
    ring_.clear();
    far_.clear();
    far_serial_ = 0;
    phase_ = ahead_ = {};
    phase_span_ = 0;
    base_ = kNoPhase;
    target_ = kMinimum;
    balance_ = 0;
    is_narrow_ = false;
  }

  /// Keeps phases as narrow as possible, until `clear`.
  void keep_sorted() { is_narrow_ = true; }

  /// @param key not negative; less than the key of the item popped last only by rounding
  void push(double key, Item item) {
    const std::int64_t number = numbers_.of(key), offset = number - base_;
    balance_ += offset >= phase_span_ ? 1 : -1;
    if (offset < kRing) {
      ring_.push(std::max(number, base_), item);
    } else {
      far_.push({std::bit_cast<std::uint64_t>(key), far_serial_++, item});
    }
  }

  /// True when the running phase takes items of this key. Such an item need not be queued.
  bool is_due(double key) const { return numbers_.of(key) - base_ < phase_span_; }

  /// As in CalendarQueue: the lower end of the running phase.
  double least_key() const { return base_ < 0 ? 0 : numbers_.least_key(base_); }

  /// An item that is popped after a few others, so that its data can be prefetched; null when none
  /// is known. Valid until the next push.
  const Item* upcoming() const {
    return ahead_.empty() ? nullptr : &ring_.nodes()[ahead_.first].item;
  }

  /// Removes and returns the next item of the phase. The queue must not be empty.
  Item pop() {
    if (phase_.empty()) start_phase();
    const Index at = phase_.first;
    phase_.drop_first(ring_.nodes());
    ahead_.drop_first(ring_.nodes());
    if (!ahead_.empty()) ring_.nodes().prefetch(ahead_.first);
    return ring_.nodes().take(at).item;
  }

 private:
  static constexpr std::ptrdiff_t kMinimum = 6;  // K stays between these
  static constexpr std::ptrdiff_t kMaximum = 1000;
  static constexpr int kAhead = 8;                  // items between the next one and `upcoming`
  static constexpr std::int64_t kRing = 1 << 14;    // buckets; a power of two
  static constexpr std::int64_t kNoPhase = -kRing;  // everything lies beyond the ring

  // Moves the ring's start to the first bucket that holds anything.
  void advance() {
    base_ = ring_.empty() ? numbers_.of(far_.least().key_value()) : ring_.next_filled(base_);
    while (!far_.empty() && numbers_.of(far_.least().key_value()) - base_ < kRing) {
      const auto entry = far_.pop();
      ring_.push(std::max(numbers_.of(entry.key_value()), base_), entry.item);
    }
  }

  void start_phase() {
    target_ = is_narrow_ ? kMinimum : std::clamp(target_ + balance_, kMinimum, kMaximum);
    balance_ = 0;
    advance();
    phase_span_ = 0;
    while (!ring_.empty() && phase_.count < target_ && phase_span_ < kRing) {
      ring_.move_behind(base_ + phase_span_++, phase_);
    }
    ahead_ = phase_;
    for (int k = 0; k < kAhead; ++k) ahead_.drop_first(ring_.nodes());
  }

  BucketNumbers numbers_;
  BucketRing<Fifo, Item> ring_;   // buckets base_ to base_ + kRing - 1
  std::int64_t base_ = kNoPhase;  // number of the running phase's first bucket
  std::int64_t phase_span_ = 0;   // buckets that the running phase took
  KeyHeap<Item> far_;             // what lies beyond the ring
  std::uint32_t far_serial_ = 0;
  Fifo phase_;                        // what is left of the running phase
  Fifo ahead_;                        // the part of it that starts with `upcoming`
  std::ptrdiff_t target_ = kMinimum;  // K: windows a phase should cover
  std::ptrdiff_t balance_ = 0;        // pushed above minus pushed below the phase's upper bound
  bool is_narrow_ = false;            // K stays at its minimum
};

}  // namespace geodesic
