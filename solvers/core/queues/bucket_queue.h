// Buckets processed in phases: the order of fast wavefront propagation.
//
// Xu, Wang, Liu, Liu, He 2015, "Fast wavefront propagation (FWP) for computing exact geodesic
// distances on meshes". Any order of propagation is correct, so windows are only sorted into
// buckets by floor(key / width). A phase takes the first buckets that together hold at least K
// windows, first in first out inside a bucket; windows born during a phase wait for the next one.
// K adapts: a phase whose children mostly lie above its upper bound was narrow enough to be
// widened, and the reverse.
//
// The buckets are a ring that starts at the running phase. Keys beyond its far end (another
// source's initial distance, a very long edge) wait in a heap until the ring gets there, so memory
// and time depend on the number of items, not on the range of their keys.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/prefetch.h"
#include "solvers/core/queues/bucket_numbers.h"
#include "solvers/core/queues/key_heap.h"

namespace geodesic {

/// Queue policy of FWP-MMP and FWP-CH. Items are small and trivially copyable.
template <class Item>
class BucketQueue {
 public:
  /// @param width keys covered by one bucket, in the keys' unit; mean edge length / sqrt(vertices)
  ///        is the published choice. Not positive: one bucket takes everything.
  explicit BucketQueue(double width) : numbers_(width), ring_(kRing) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void clear() {
    std::fill(ring_.begin(), ring_.end(), Bucket{});
    far_.clear();
    far_serial_ = 0;
    nodes_.clear();
    free_ = kEnd;
    phase_ = ahead_ = {};
    size_ = in_ring_ = 0;
    head_ = phase_span_ = 0;
    base_ = kNoPhase;
    target_ = kMinimum;
    balance_ = 0;
  }

  /// @param key not negative; less than the key of the item popped last only by rounding
  void push(double key, Item item) {
    const std::int64_t offset = numbers_.of(key) - base_;
    balance_ += offset >= phase_span_ ? 1 : -1;
    if (offset < kRing) {
      put(offset, item);
    } else {
      far_.push({std::bit_cast<std::uint64_t>(key), far_serial_++, item});
    }
    ++size_;
  }

  /// True when the running phase takes items of this key, so that one need not be queued.
  bool is_due(double key) const { return numbers_.of(key) - base_ < phase_span_; }

  /// As of PriorityQueue: the lower end of the running phase.
  double least_key() const { return base_ < 0 ? 0 : numbers_.least_key(base_); }

  /// An item that a few others precede, for its data to be fetched meanwhile; null when none is
  /// known. Valid until the next push.
  const Item* upcoming() const { return ahead_.count > 0 ? &nodes_[ahead_.first].item : nullptr; }

  /// Removes and returns the next item of the phase. The queue must not be empty.
  Item pop() {
    if (phase_.count == 0) start_phase();
    const std::uint32_t at = phase_.first;
    drop_first(phase_);
    drop_first(ahead_);
    if (ahead_.count > 0) prefetch(&nodes_[ahead_.first]);
    --size_;
    nodes_[at].next = free_;
    free_ = at;
    return nodes_[at].item;
  }

 private:
  static constexpr std::ptrdiff_t kMinimum = 6;     // K never falls below
  static constexpr int kAhead = 8;                  // items between the next one and `upcoming`
  static constexpr std::int64_t kRing = 1 << 14;    // buckets; a power of two
  static constexpr std::uint32_t kEnd = ~0u;        // no node
  static constexpr std::int64_t kNoPhase = -kRing;  // everything lies beyond the ring

  struct Node {
    Item item;
    std::uint32_t next;
  };
  struct Bucket {  // a list of nodes in order of arrival
    std::uint32_t first = kEnd, last = kEnd;
    std::uint32_t count = 0;
  };

  void drop_first(Bucket& from) const {
    if (from.count == 0) return;
    from.first = nodes_[from.first].next;
    --from.count;
  }

  Bucket& bucket(std::int64_t offset) {
    return ring_[static_cast<std::size_t>((head_ + offset) & (kRing - 1))];
  }

  void put(std::int64_t offset, Item item) {
    Bucket& into = bucket(std::max<std::int64_t>(offset, 0));
    const std::uint32_t at = new_node(item);
    (into.count == 0 ? into.first : nodes_[into.last].next) = at;
    into.last = at;
    ++into.count;
    ++in_ring_;
  }

  std::uint32_t new_node(Item item) {
    if (free_ == kEnd) {
      nodes_.push_back({item, kEnd});
      return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    const std::uint32_t at = free_;
    free_ = nodes_[at].next;
    nodes_[at] = {item, kEnd};
    return at;
  }

  // Moves the ring's start to the first bucket that holds anything.
  void advance() {
    if (in_ring_ == 0) {
      base_ = numbers_.of(far_.least().key_value());
    } else {
      std::int64_t empty = 0;
      while (bucket(empty).count == 0) ++empty;
      head_ += empty;
      base_ += empty;
    }
    while (!far_.empty() && numbers_.of(far_.least().key_value()) - base_ < kRing) {
      const auto entry = far_.pop();
      put(numbers_.of(entry.key_value()) - base_, entry.item);
    }
  }

  void start_phase() {
    target_ = std::max(kMinimum, target_ + balance_);
    balance_ = 0;
    advance();
    phase_span_ = 0;
    while (in_ring_ > 0 && phase_.count < target_ && phase_span_ < kRing) {
      take(bucket(phase_span_++));
    }
    ahead_ = phase_;
    for (int k = 0; k < kAhead; ++k) drop_first(ahead_);
  }

  void take(Bucket& from) {
    if (from.count == 0) return;
    (phase_.count == 0 ? phase_.first : nodes_[phase_.last].next) = from.first;
    phase_.last = from.last;
    phase_.count += from.count;
    in_ring_ -= from.count;
    from = {};
  }

  BucketNumbers numbers_;
  std::vector<Bucket> ring_;      // buckets base_ to base_ + kRing - 1
  std::int64_t head_ = 0;         // position of bucket base_ in the ring, modulo its size
  std::int64_t base_ = kNoPhase;  // number of the running phase's first bucket
  std::int64_t phase_span_ = 0;   // buckets that the running phase took
  KeyHeap<Item> far_;             // what lies beyond the ring
  std::uint32_t far_serial_ = 0;
  std::vector<Node> nodes_;
  std::uint32_t free_ = kEnd;  // first of the unused nodes
  Bucket phase_;               // what is left of the running phase
  Bucket ahead_;               // the part of it that starts with `upcoming`
  std::size_t in_ring_ = 0;
  std::size_t size_ = 0;
  std::ptrdiff_t target_ = kMinimum;  // K: windows a phase should cover
  std::ptrdiff_t balance_ = 0;        // pushed above minus pushed below the phase's upper bound
};

}  // namespace geodesic
