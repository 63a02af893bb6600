#include "harness/base/limits.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace geodesic::harness {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

// The number that a file begins with; nothing for "max", or where there is no such file.
std::optional<std::uint64_t> number_in(const char* file) {
  std::uint64_t number = 0;
  if (std::ifstream(file) >> number) return number;
  return std::nullopt;
}

// Control groups of version 2, and of version 1.
std::uint64_t left_in_control_group() {
  constexpr const char* kFiles[][2] = {
      {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
      {"/sys/fs/cgroup/memory/memory.limit_in_bytes",
       "/sys/fs/cgroup/memory/memory.usage_in_bytes"}};
  std::uint64_t left = kUnlimited;
  for (const auto& [limit_file, used_file] : kFiles) {
    const auto limit = number_in(limit_file), used = number_in(used_file);
    if (limit && used) left = std::min(left, *limit - std::min(*limit, *used));
  }
  return left;
}

std::uint64_t available_in_system() {
  std::ifstream meminfo("/proc/meminfo");
  for (std::string key; meminfo >> key;) {
    std::uint64_t kib = 0;
    if (key == "MemAvailable:" && meminfo >> kib) return kib * 1024;
    meminfo.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return kUnlimited;
}

}  // namespace

std::uint64_t memory_to_give() {
  return std::min(available_in_system(), left_in_control_group()) / 10 * 9;
}

}  // namespace geodesic::harness
