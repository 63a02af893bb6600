#include "harness/base/control_groups.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "harness/base/clock.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

// The number at the start of a file; empty for "max", or if there is no such file.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::uint64_t number = 0;
  if (std::ifstream(file) >> number) return number;
  return std::nullopt;
}

// Calls `look` with the folder of each group of a controller, and of every group above it.
// @param look the folder, and whether it is of version 1 of control groups
void for_each_group(std::istream& groups, const fs::path& root, const std::string& controller,
                    const std::function<void(const fs::path&, bool)>& look) {
  for (std::string line; std::getline(groups, line);) {
    std::istringstream parts(line);
    std::string number, controllers, group;
    std::getline(parts, number, ':');
    std::getline(parts, controllers, ':');
    std::getline(parts, group);
    const bool is_first =
        (',' + controllers + ',').find(',' + controller + ',') != std::string::npos;
    if (!is_first && !controllers.empty()) continue;
    fs::path folder = is_first ? root / controller : root;
    look(folder, is_first);
    for (const fs::path& name : fs::path(group).relative_path()) {
      folder /= name;
      look(folder, is_first);
    }
  }
}

}  // namespace

std::uint64_t left_in_control_groups(std::istream& groups, const fs::path& root) {
  std::uint64_t left = kUnlimited;
  for_each_group(groups, root, "memory", [&](const fs::path& folder, bool is_first) {
    const auto limit = number_in(folder / (is_first ? "memory.limit_in_bytes" : "memory.max"));
    const auto used = number_in(folder / (is_first ? "memory.usage_in_bytes" : "memory.current"));
    if (limit && used) left = std::min(left, *limit - std::min(*limit, *used));
  });
  return left;
}

std::optional<double> processors_in_control_groups(std::istream& groups, const fs::path& root) {
  std::optional<double> least;
  for_each_group(groups, root, "cpu", [&](const fs::path& folder, bool is_first) {
    // Version 2 has both numbers in one file. Without a limit, the first is "max", or -1.
    std::ifstream times(folder / (is_first ? "cpu.cfs_quota_us" : "cpu.max"));
    std::ifstream of_first(folder / "cpu.cfs_period_us");
    double quota = 0, period = 0;
    if (!(times >> quota) || !((is_first ? of_first : times) >> period)) return;
    if (quota > 0 && period > 0) least = std::min(least.value_or(quota / period), quota / period);
  });
  return least;
}

std::uint64_t available_memory() {
  const auto in_system = proc_bytes("/proc/meminfo", "MemAvailable:");
  const std::uint64_t left = in_system ? static_cast<std::uint64_t>(*in_system) : kUnlimited;
  std::ifstream groups("/proc/self/cgroup");
  return std::min(left, left_in_control_groups(groups, "/sys/fs/cgroup")) / 10 * 9;
}

}  // namespace geodesic::harness
