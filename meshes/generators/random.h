// Random numbers that are the same everywhere; the distributions of `<random>` are not.
#pragma once

#include <cstdint>

namespace geodesic::generators {

/// The output function of SplitMix64: a bijection of 64-bit words whose outputs on 0, g, 2g, ...
/// (g the odd constant) pass statistical test suites. Steele, Lea, Flood 2014, "Fast splittable
/// pseudorandom number generators", with the multipliers of Stafford's variant 13.
inline std::uint64_t split_mix(std::uint64_t state) {
  std::uint64_t z = state + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A number in [-1, 1) from the upper 53 bits of a random word.
inline double to_signed_unit(std::uint64_t word) {
  return static_cast<double>(word >> 11) * 0x1p-52 - 1;
}

}  // namespace geodesic::generators
