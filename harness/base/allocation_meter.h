// Bytes that the program holds on the heap through operator new.
//
// The program's operator new and delete are replaced (allocation_meter.cpp). While no meter exists
// they cost one predictable branch more than usual: timed solves run without a meter.
#pragma once

#include <cstdint>

namespace geodesic::harness {

/// Counts the requested bytes from its construction to its destruction. The counts are the same in
/// every run. At most one meter exists at a time. Memory from malloc itself is not counted.
class AllocationMeter {
 public:
  AllocationMeter();
  ~AllocationMeter();
  AllocationMeter(const AllocationMeter&) = delete;
  AllocationMeter& operator=(const AllocationMeter&) = delete;

  /// Bytes allocated and not freed since the construction.
  std::int64_t live_bytes() const;
  /// The largest value of live_bytes() so far.
  std::int64_t peak_bytes() const;
};

}  // namespace geodesic::harness
