// Items in order of their key, equal keys in order of insertion.
//
// A wavefront's keys lie close together and new ones lie mostly ahead. Items are therefore only
// sorted into narrow buckets by floor(key / width), a ring that starts behind the bucket that is
// being emptied; that one is a heap, of a few items. What lies beyond the ring (another source's
// initial distance, a very long edge) waits in a heap of its own. The order is that of one heap of
// everything.
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

/// How keys are sorted into buckets.
struct PriorityBuckets {
  double width;  ///< keys covered by one, in the keys' unit; best when a bucket holds but a few
                 ///< items. Not positive: one heap takes everything.
  std::size_t count;  ///< of the ring, a power of two from 8 on; best when few items lie beyond
};

/// Queue policy of MMP and ICH. Items are small and trivially copyable (an index).
template <class Item>
class PriorityQueue {
 public:
  explicit PriorityQueue(const PriorityBuckets& buckets)
      : numbers_(buckets.width), ring_(buckets.count, kEnd), mask_(buckets.count - 1) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void clear() {
    near_.clear();
    far_.clear();
    std::fill(ring_.begin(), ring_.end(), kEnd);
    nodes_.clear();
    free_ = kEnd;
    in_ring_ = size_ = 0;
    current_ = preview_bucket_ = 0;
    preview_ = kEnd;
    serial_ = 0;
  }

  /// @param key not negative
  void push(double key, Item item) {
    const Entry entry{std::bit_cast<std::uint64_t>(key), serial_++, item};
    const std::uint64_t bucket = number(entry);
    ++size_;
    if (bucket <= current_) {
      near_.push(entry);
    } else if (bucket - current_ <= mask_) {
      put(ring_[bucket & mask_], entry);
    } else {
      far_.push(entry);
    }
  }

  /// True when no item has a smaller key, so that one of this key need not be queued.
  bool is_due(double key) const {
    const Entry entry{std::bit_cast<std::uint64_t>(key), 0, {}};
    if (near_.empty()) return size_ == 0 || number(entry) <= current_;
    return entry.key <= near_.least().key;
  }

  /// No item has a smaller key, nor one pushed from now on unless it lies behind the item popped
  /// last. Cheap rather than tight.
  double least_key() const { return numbers_.least_key(static_cast<std::int64_t>(current_)); }

  /// Some item that will be popped soon but not next, another one at each call, for its data to be
  /// fetched meanwhile; null when none is known. Valid until the next push.
  const Item* upcoming() {
    if (preview_bucket_ <= current_) {
      preview_bucket_ = current_ + 1;
      preview_ = ring_[preview_bucket_ & mask_];
    }
    while (preview_ == kEnd) {
      if (preview_bucket_ - current_ >= kPreview) return nullptr;
      preview_ = ring_[++preview_bucket_ & mask_];
      prefetch(nodes_.data() + ring_[(preview_bucket_ + 1) & mask_]);
    }
    const Node& node = nodes_[preview_];
    preview_ = node.next;
    if (preview_ != kEnd) prefetch(&nodes_[preview_]);
    return &node.entry.item;
  }

  /// Removes and returns the item of least key. The queue must not be empty.
  Item pop() {
    if (near_.empty()) advance();
    --size_;
    return near_.pop().item;
  }

 private:
  using Entry = KeyedItem<Item>;
  static constexpr std::uint64_t kPreview = 4;  // buckets that `upcoming` looks into
  static constexpr std::uint32_t kEnd = ~0u;    // no node

  struct Node {
    Entry entry;
    std::uint32_t next;
  };

  std::uint64_t number(const Entry& entry) const {
    return static_cast<std::uint64_t>(numbers_.of(entry.key_value()));
  }

  void put(std::uint32_t& bucket, const Entry& entry) {
    std::uint32_t at = free_;
    if (at == kEnd) {
      at = static_cast<std::uint32_t>(nodes_.size());
      nodes_.emplace_back();
    } else {
      free_ = nodes_[at].next;
    }
    nodes_[at] = {entry, bucket};
    bucket = at;
    ++in_ring_;
  }

  // Moves a bucket's items, in whatever order they lie there, into near_.
  void take(std::uint32_t& bucket) {
    while (bucket != kEnd) {
      const std::uint32_t at = bucket;
      near_.push(nodes_[at].entry);
      bucket = nodes_[at].next;
      nodes_[at].next = free_;
      free_ = at;
      --in_ring_;
    }
  }

  // Makes the first bucket that holds anything the current one. As long as the ring holds an item,
  // that is nearer than the ring's end: a place in the ring never stands for two buckets.
  void advance() {
    std::uint64_t next = far_.empty() ? UINT64_MAX : number(far_.least());
    if (in_ring_ > 0) {
      std::uint64_t nearest = current_ + 1;
      while (ring_[nearest & mask_] == kEnd) ++nearest;
      next = std::min(next, nearest);
    }
    current_ = next;
    take(ring_[current_ & mask_]);
    while (!far_.empty() && number(far_.least()) == current_) near_.push(far_.pop());
  }

  BucketNumbers numbers_;
  KeyHeap<Item> near_;               // buckets up to current_
  std::vector<std::uint32_t> ring_;  // first node of buckets current_ + 1 ... current_ + mask_
  std::size_t mask_;                 // of a bucket's number: its place in the ring
  KeyHeap<Item> far_;                // what lay beyond the ring when it was pushed
  std::vector<Node> nodes_;
  std::uint32_t free_ = kEnd;  // first of the unused nodes
  std::uint64_t current_ = 0;
  std::uint64_t preview_bucket_ = 0;  // where `upcoming` has got to: a bucket not emptied yet,
  std::uint32_t preview_ = kEnd;      // and its node
  std::size_t in_ring_ = 0;
  std::size_t size_ = 0;
  std::uint32_t serial_ = 0;
};

}  // namespace geodesic
