// Bytes that the program holds on the heap through operator new.
//
// The program's operator new and delete are replaced (allocation_meter.cpp). While no meter exists
// they cost one predictable branch more than usual: timed solves run without a meter.
#pragma once

#include <cstdint>

namespace geodesic::harness {

/// Counts from its construction to its destruction, in the sizes that are asked for: the same in
/// every run. One meter at a time; memory obtained by malloc directly is not seen.
class AllocationMeter {
 public:
  AllocationMeter();
  ~AllocationMeter();
  AllocationMeter(const AllocationMeter&) = delete;
  AllocationMeter& operator=(const AllocationMeter&) = delete;

  /// Bytes allocated and not freed since the meter exists.
  std::int64_t live_bytes() const;
  /// The largest value that live_bytes has had.
  std::int64_t peak_bytes() const;
};

}  // namespace geodesic::harness
