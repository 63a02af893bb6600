#include "harness/results/environment.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "harness/base/build_info.h"
#include "harness/base/control_groups.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

/// The text after "key<blanks>:<blanks>" in a file of /proc; empty if there is none.
std::string line_in(const fs::path& file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos) continue;
    if (line.find_first_not_of(" \t", key.size()) != colon) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return {};
}

/// The governors of the processors' clocks: "performance", or several.
std::string governors() {
  std::set<std::string> all;
  std::error_code none;
  for (const auto& policy : fs::directory_iterator("/sys/devices/system/cpu/cpufreq", none)) {
    std::string name;
    if (std::ifstream(policy.path() / "scaling_governor") >> name) all.insert(name);
  }
  std::string text;
  for (const std::string& name : all) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Those of the build, and the C library that is loaded.
std::string libraries() {
  std::string all = build_info().libraries;
#ifdef _CS_GNU_LIBC_VERSION
  char c_library[64];  // "glibc 2.36"
  if (confstr(_CS_GNU_LIBC_VERSION, c_library, sizeof c_library) > 0) {
    all += std::string(", ") + c_library;
  }
#endif
  return all;
}

}  // namespace

std::string processor() {
  const std::string name = line_in("/proc/cpuinfo", "model name");
  return name.empty() ? "unknown" : name;
}

Json environment() {
  Json found{{"started", utc_now()}, {"processor", processor()}, {"libraries", libraries()}};
  const auto add = [&](const char* key, const std::string& text) {
    if (!text.empty()) found[key] = text;
  };
  add("microcode", line_in("/proc/cpuinfo", "microcode"));
  utsname system{};
  if (uname(&system) == 0) add("kernel", std::string(system.sysname) + ' ' + system.release);
  add("governor", governors());
  add("cores", line_in("/proc/self/status", "Cpus_allowed_list"));
  std::ifstream groups("/proc/self/cgroup");
  if (const auto limit = processors_in_control_groups(groups, "/sys/fs/cgroup")) {
    found["core_limit"] = *limit;
  }
  double load = 0;
  if (getloadavg(&load, 1) == 1) found["load"] = load;
  return found;
}

bool are_alike(Json one, Json other) {
  for (const char* key : {"started", "load"}) {
    one.erase(key);
    other.erase(key);
  }
  return one == other;
}

}  // namespace geodesic::harness
