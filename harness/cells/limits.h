// What a process may take.
#pragma once

#include <cstdint>
#include <limits>

namespace geodesic::harness {

struct Limits {
  double seconds = std::numeric_limits<double>::infinity();  ///< then the process is killed
  std::uint64_t memory_bytes =
      std::numeric_limits<std::uint64_t>::max();  ///< of address space; more is not granted
};

/// Memory that this machine can give to new processes without swapping, in bytes: what Linux calls
/// available, and no more than what the control group of this process leaves.
std::uint64_t available_memory_bytes();

}  // namespace geodesic::harness
