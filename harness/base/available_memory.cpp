#include "harness/base/available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "harness/base/clock.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

// The files of a version of control groups, in the folder of each group.
struct Version {
  const char* mount;  // below the root
  const char* limit;
  const char* used;
};
constexpr Version kFirst{"memory", "memory.limit_in_bytes", "memory.usage_in_bytes"};
constexpr Version kSecond{"", "memory.max", "memory.current"};

// The number at the start of a file; empty for "max", or if there is no such file.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::uint64_t number = 0;
  if (std::ifstream(file) >> number) return number;
  return std::nullopt;
}

// Of a group and of every group above it.
std::uint64_t left_in(const fs::path& mount, const fs::path& group, const Version& version) {
  std::uint64_t left = kUnlimited;
  fs::path folder = mount;
  const auto look = [&] {
    const auto limit = number_in(folder / version.limit), used = number_in(folder / version.used);
    if (limit && used) left = std::min(left, *limit - std::min(*limit, *used));
  };
  look();
  for (const fs::path& name : group.relative_path()) {
    folder /= name;
    look();
  }
  return left;
}

}  // namespace

std::uint64_t left_in_control_groups(std::istream& groups, const fs::path& root) {
  std::uint64_t left = kUnlimited;
  for (std::string line; std::getline(groups, line);) {
    std::istringstream parts(line);
    std::string number, controllers, group;
    std::getline(parts, number, ':');
    std::getline(parts, controllers, ':');
    std::getline(parts, group);
    const bool is_first = (',' + controllers + ',').find(",memory,") != std::string::npos;
    if (!is_first && !controllers.empty()) continue;
    const Version& version = is_first ? kFirst : kSecond;
    left = std::min(left, left_in(root / version.mount, group, version));
  }
  return left;
}

std::uint64_t available_memory() {
  const auto in_system = proc_bytes("/proc/meminfo", "MemAvailable:");
  const std::uint64_t left = in_system ? static_cast<std::uint64_t>(*in_system) : kUnlimited;
  std::ifstream groups("/proc/self/cgroup");
  return std::min(left, left_in_control_groups(groups, "/sys/fs/cgroup")) / 10 * 9;
}

}  // namespace geodesic::harness
