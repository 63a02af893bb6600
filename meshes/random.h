// Pseudo-random numbers that are the same on every machine and standard library, unlike the
// distributions of `<random>`.
#pragma once

#include <cstdint>
#include <random>
#include <utility>

namespace geodesic {

/// The constant g: 2^64 divided by the golden ratio, odd.
inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15u;

/// The output function of SplitMix64: a bijection of 64-bit words. Its values at 0, g, 2g, ... pass
/// statistical test suites. Steele, Lea, Flood 2014, "Fast splittable pseudorandom number
/// generators", with the multipliers of Stafford's variant 13.
inline std::uint64_t split_mix(std::uint64_t state) {
  std::uint64_t z = state + kSplitMixStep;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The sequence of split_mix at seed, seed + g, seed + 2g, ...
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() { return split_mix(std::exchange(state_, state_ + kSplitMixStep)); }

 private:
  std::uint64_t state_;
};

/// Returns a number in [-1, 1) from the upper 53 bits of a random word.
inline double to_signed_unit(std::uint64_t word) {
  return static_cast<double>(word >> 11) * 0x1p-52 - 1;
}

/// Uniform random numbers.
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

}  // namespace geodesic
