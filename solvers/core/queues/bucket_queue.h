// Buckets processed in phases: the order of fast wavefront propagation.
//
// Xu, Wang, Liu, Liu, He 2015, "Fast wavefront propagation (FWP) for computing exact geodesic
// distances on meshes". Any order of propagation is correct, so windows are only sorted into
// buckets by floor(key / width). A phase takes the first buckets that together hold at least K
// windows; windows born during a phase wait for the next one. K adapts: a phase whose children
// mostly lie above its upper bound was narrow enough to be widened, and the reverse.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

namespace geodesic {

/// Queue policy of FWP-MMP and FWP-CH.
template <class Item>
class BucketQueue {
 public:
  /// @param width keys covered by one bucket, in the keys' unit; mean edge length / sqrt(vertices)
  ///        is the published choice
  explicit BucketQueue(double width) : per_width_(width > 0 ? 1 / width : 0) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void clear() {
    buckets_.clear();
    phase_.clear();
    taken_ = size_ = 0;
    first_ = 0;
    target_ = kMinimum;
    balance_ = 0;
  }

  void push(double key, Item item) {
    const std::ptrdiff_t number = static_cast<std::ptrdiff_t>(std::floor(key * per_width_));
    if (size_ == 0) first_ = number;
    balance_ += number >= phase_end_ ? 1 : -1;
    while (number < first_) {  // a window born behind the wavefront's first bucket
      buckets_.emplace_front();
      --first_;
    }
    const std::size_t at = static_cast<std::size_t>(number - first_);
    if (at >= buckets_.size()) buckets_.resize(at + 1);
    buckets_[at].push_back(item);
    ++size_;
  }

  /// Removes and returns the next item of the phase. The queue must not be empty.
  Item pop() {
    if (taken_ == phase_.size()) start_phase();
    --size_;
    return phase_[taken_++];
  }

 private:
  static constexpr std::ptrdiff_t kMinimum = 6;

  void start_phase() {
    target_ = std::max(kMinimum, target_ + balance_);
    balance_ = 0;
    phase_.clear();
    taken_ = 0;
    while (!buckets_.empty() && static_cast<std::ptrdiff_t>(phase_.size()) < target_) {
      phase_.insert(phase_.end(), buckets_.front().begin(), buckets_.front().end());
      buckets_.pop_front();
      ++first_;
    }
    phase_end_ = first_;
  }

  double per_width_;
  std::deque<std::vector<Item>> buckets_;
  std::ptrdiff_t first_ = 0;      // number of the first bucket
  std::ptrdiff_t phase_end_ = 0;  // number of the first bucket behind the running phase
  std::vector<Item> phase_;
  std::size_t taken_ = 0;
  std::size_t size_ = 0;
  std::ptrdiff_t target_ = kMinimum;  // K: windows a phase should cover
  std::ptrdiff_t balance_ = 0;        // pushed above minus pushed below the phase's upper bound
};

}  // namespace geodesic
