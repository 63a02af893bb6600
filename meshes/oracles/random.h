// Pseudo-random numbers that are the same on every machine and standard library.
#pragma once

#include <cstdint>
#include <random>

namespace geodesic::oracles {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// Uniform in [low, high).
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  /// Uniform in {0, ..., count - 1}, up to a bias of count / 2^64.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits_() % count); }

 private:
  std::mt19937_64 bits_;  // its sequence is fixed by the standard; distributions are not
};

}  // namespace geodesic::oracles
