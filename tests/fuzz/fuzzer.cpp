// Entry point for libFuzzer. An exception ends the process, which libFuzzer reports as a finding.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  geodesic::harness::fuzz::check_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
