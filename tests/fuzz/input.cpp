#include "tests/fuzz/input.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "harness/base/allocation_meter.h"
#include "harness/base/error.h"

namespace geodesic::harness::fuzz {
namespace {

// Allowed heap bytes: per byte of the file, and a constant for every file.
constexpr std::int64_t kPerByte = 1000;
constexpr std::int64_t kForAnyFile = 1 << 20;

void check_message(const std::string& message) {
  const bool one_line = std::none_of(message.begin(), message.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (!one_line || message.empty() || message.size() > 2000) {
    throw std::logic_error("the message is not one short line: " + message);
  }
}

}  // namespace

void check_input(std::string_view bytes) {
  const AllocationMeter meter;
  try {
    read_input(bytes);
  } catch (const MeshError& refused) {
    check_message(refused.what());
  } catch (const HarnessError& refused) {
    check_message(refused.what());
  }
  const std::int64_t allowed = kForAnyFile + kPerByte * static_cast<std::int64_t>(bytes.size());
  if (meter.peak_bytes() > allowed) {
    throw std::logic_error("a file of " + std::to_string(bytes.size()) + " bytes took " +
                           std::to_string(meter.peak_bytes()) + " bytes of memory, more than " +
                           std::to_string(allowed));
  }
}

}  // namespace geodesic::harness::fuzz
