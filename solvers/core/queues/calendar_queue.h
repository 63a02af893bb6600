// A calendar queue (bucket_ring.h): items in order of their key, equal keys in order of insertion.
//
// Buckets are narrow, and only the current one is sorted, as a heap of a few items. Items beyond
// the ring (another source's initial distance, a very long edge) wait in another heap. The order is
// the same as that of one heap of all items.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "solvers/core/queues/bucket_ring.h"
#include "solvers/core/queues/key_heap.h"

namespace geodesic {

/// How a calendar queue sorts keys into buckets.
struct CalendarBuckets {
  double width;  ///< keys covered by one, in the keys' unit; best when a bucket holds only a few
                 ///< items. 0: one heap takes everything.
  std::size_t count;  ///< of the ring, a power of two from 8 on; best when few items lie beyond
};

/// Measured: ICH is fastest at a sixteenth of the published width, within 5% from an eighth to a
/// thirty-second. A child's key lies up to about one edge ahead of its parent's; the finer a mesh
/// is, the more buckets that is. There are enough buckets for two to four mean edge lengths.
inline CalendarBuckets calendar_buckets(const Mesh& mesh) {
  constexpr double kFiner = 16;
  const double an_edge = kFiner * std::sqrt(static_cast<double>(mesh.vertex_count()));
  return {.width = published_bucket_width(mesh) / kFiner,
          .count = std::bit_ceil(static_cast<std::size_t>(std::max(2 * an_edge, 1024.0)))};
}

/// The queue of MMP and ICH. Items are small and trivially copyable (an index).
template <class Item>
class CalendarQueue {
 public:
  explicit CalendarQueue(const CalendarBuckets& buckets)
      : numbers_(buckets.width), ring_(buckets.count) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void clear() {
    near_.clear();
    far_.clear();
    ring_.clear();
    size_ = 0;
    current_ = preview_bucket_ = 0;
    preview_ = kNone;
    serial_ = 0;
  }

  /// @param key not negative
  void push(double key, Item item) {
    const Entry entry{std::bit_cast<std::uint64_t>(key), serial_++, item};
    const std::int64_t number = number_of(entry);
    ++size_;
    if (number <= current_) {
      near_.push(entry);
    } else if (number - current_ < ring_.size()) {
      ring_.push(number, entry);
    } else {
      far_.push(entry);
    }
  }

  /// True when no item has a smaller key. An item of this key need not be queued then.
  bool is_due(double key) const {
    const Entry entry{std::bit_cast<std::uint64_t>(key), 0, {}};
    if (near_.empty()) return size_ == 0 || number_of(entry) <= current_;
    return entry.key <= near_.least().key;
  }

  /// No item has a smaller key, nor has one pushed later unless it lies behind the item popped
  /// last. A cheap bound, not a tight one.
  double least_key() const { return numbers_.least_key(current_); }

  /// An item that will be popped soon but not next, another one at each call, so that its data can
  /// be prefetched; null when none is known. Valid until the next push.
  const Item* upcoming() {
    if (preview_bucket_ <= current_) {
      preview_bucket_ = current_ + 1;
      preview_ = ring_.bucket(preview_bucket_).first;
    }
    while (preview_ == kNone) {
      if (preview_bucket_ - current_ >= kPreview) return nullptr;
      preview_ = ring_.bucket(++preview_bucket_).first;
      ring_.nodes().prefetch(ring_.bucket(preview_bucket_ + 1).first);
    }
    const BucketNode<Entry>& node = ring_.nodes()[preview_];
    preview_ = node.next;
    if (preview_ != kNone) ring_.nodes().prefetch(preview_);
    return &node.item.item;
  }

  /// Removes and returns the item of least key. The queue must not be empty.
  Item pop() {
    if (near_.empty()) advance();
    --size_;
    return near_.pop().item;
  }

 private:
  using Entry = KeyedItem<Item>;
  static constexpr std::int64_t kPreview = 4;  // buckets that `upcoming` looks into

  std::int64_t number_of(const Entry& entry) const { return numbers_.of(entry.key_value()); }

  // Makes the first bucket that holds an item the current one. As long as the ring holds an item,
  // that bucket is nearer than the ring's end: a place in the ring never stands for two buckets.
  void advance() {
    std::int64_t next = far_.empty() ? INT64_MAX : number_of(far_.least());
    if (!ring_.empty()) next = std::min(next, ring_.next_filled(current_ + 1));
    current_ = next;
    ring_.drain(current_, [&](const Entry& entry) { near_.push(entry); });
    while (!far_.empty() && number_of(far_.least()) == current_) near_.push(far_.pop());
  }

  BucketNumbers numbers_;
  KeyHeap<Item> near_;             // buckets up to current_
  BucketRing<Stack, Entry> ring_;  // buckets behind current_
  KeyHeap<Item> far_;              // items that lay beyond the ring when they were pushed
  std::int64_t current_ = 0;
  std::int64_t preview_bucket_ = 0;  // where `upcoming` has got to: a bucket not emptied yet,
  Index preview_ = kNone;            // and its node
  std::size_t size_ = 0;
  std::uint32_t serial_ = 0;
};

}  // namespace geodesic
