// Which bucket a key belongs to.
#pragma once

#include <algorithm>
#include <cstdint>

namespace geodesic {

/// Buckets of equal width, numbered from 0; a number never falls when a key grows. Keys too large
/// to be numbered share the last bucket.
class BucketNumbers {
 public:
  /// @param width keys covered by one bucket; not positive: one bucket takes everything
  explicit BucketNumbers(double width)
      : per_width_(width > 0 ? std::min(1 / width, kGreatestFactor) : 0) {}

  /// @param key not negative
  std::int64_t of(double key) const {
    return static_cast<std::int64_t>(std::min(key * per_width_, kGreatestNumber));
  }

  /// No key of this bucket or of a later one is smaller.
  double least_key(std::int64_t number) const {
    return per_width_ > 0 ? static_cast<double>(number) / per_width_ * kRoundedDown : 0;
  }

 private:
  static constexpr double kRoundedDown = 1 - 1e-15;
  static constexpr double kGreatestFactor = 1e300;
  static constexpr double kGreatestNumber = 9e18;  // fits std::int64_t

  double per_width_;
};

}  // namespace geodesic
