// What a process may take.
#pragma once

#include <cstdint>
#include <limits>

namespace geodesic::harness {

struct ProcessLimits {
  double seconds = std::numeric_limits<double>::infinity();  ///< then the process is killed
  std::uint64_t memory_bytes =
      std::numeric_limits<std::uint64_t>::max();  ///< of address space; more is not granted
};

/// Memory that new processes may have together, in bytes: nine tenths of what Linux calls
/// available, or of what the control group of this process leaves where that is less.
std::uint64_t memory_to_give();

}  // namespace geodesic::harness
