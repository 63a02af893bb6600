// The vertices that a search has reached and not yet left, in buckets of distances.
//
// A vertex that comes nearer is entered again, and its older entry remains. Entries need no places
// that could be looked up, and those of a bucket can be looked at ahead of their turn: both save
// cache misses, which are most of the time of a search (compare core/queues/vertex_calendar.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/core/queues/bucket_ring.h"

namespace geodesic::straight_graph {

class Front {
 public:
  /// @param width distances covered by a bucket; 0: all are in one
  explicit Front(double width) : numbers_(width), slots_(kSlots) {}

  /// The number of the bucket of a distance.
  std::int64_t bucket_of(double distance) const { return numbers_.of(distance); }

  /// @param bucket not before the current one
  void push(Index v, std::int64_t bucket) {
    if (bucket - current_ >= kSlots) {
      far_.push_back({v, bucket});
      least_far_ = std::min(least_far_, bucket);
      return;
    }
    slot(bucket).push_back(v);
    ++waiting_;
  }

  /// Drops the current bucket and moves on to the next one that has entries. The first one is
  /// current after the first call. @return false if there is none
  bool advance() {
    waiting_ -= bucket().size();
    slot(current_).clear();
    if (waiting_ == 0 && far_.empty()) return false;
    do {
      current_ = waiting_ > 0 ? current_ + 1 : least_far_;
      if (current_ == least_far_) bring_near();
    } while (bucket().empty());
    return true;
  }

  /// The entries of the current bucket, which grows as more are pushed there.
  const std::vector<Index>& bucket() const {
    return slots_[static_cast<std::size_t>(current_) % kSlots];
  }

  /// No entry of the current bucket or a later one has a smaller distance.
  double least_distance() const { return numbers_.least_key(current_); }

  void clear() {
    for (std::vector<Index>& each : slots_) each.clear();
    far_.clear();
    waiting_ = 0;
    current_ = kBeforeFirst;
    least_far_ = kNoBucket;
  }

 private:
  struct Far {
    Index vertex;
    std::int64_t bucket;
  };
  static constexpr std::int64_t kSlots = 256;  // a power of two
  static constexpr std::int64_t kBeforeFirst = -1;
  static constexpr std::int64_t kNoBucket = INT64_MAX;

  std::vector<Index>& slot(std::int64_t bucket) {
    return slots_[static_cast<std::size_t>(bucket) % kSlots];
  }

  /// Enters into the slots what they now reach.
  void bring_near() {
    std::vector<Far> all;
    all.swap(far_);
    least_far_ = kNoBucket;
    for (const Far& each : all) push(each.vertex, each.bucket);
  }

  BucketNumbers numbers_;
  std::vector<std::vector<Index>> slots_;  // by bucket modulo kSlots
  std::vector<Far> far_;                   // beyond the slots
  std::size_t waiting_ = 0;                // entries in slots
  std::int64_t current_ = kBeforeFirst;
  std::int64_t least_far_ = kNoBucket;
};

}  // namespace geodesic::straight_graph
