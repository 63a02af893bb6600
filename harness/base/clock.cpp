#include "harness/base/clock.h"

#include <malloc.h>
#include <time.h>

#include <fstream>
#include <string>

namespace geodesic::harness {
namespace {

double read_clock(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Stopwatch::Stopwatch()
    : real_start_(read_clock(CLOCK_MONOTONIC)), cpu_start_(read_clock(CLOCK_PROCESS_CPUTIME_ID)) {}

double Stopwatch::real_seconds() const { return read_clock(CLOCK_MONOTONIC) - real_start_; }

double Stopwatch::cpu_seconds() const { return read_clock(CLOCK_PROCESS_CPUTIME_ID) - cpu_start_; }

double thread_cpu_seconds() { return read_clock(CLOCK_THREAD_CPUTIME_ID); }

void restart_peak_resident_bytes() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // proc(5): resets the peak to the present size
}

std::optional<std::int64_t> proc_bytes(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string word; lines >> word;) {
    std::int64_t kibibytes = 0;
    if (word == key && lines >> kibibytes) return kibibytes * 1024;
    std::getline(lines, word);
  }
  return std::nullopt;
}

std::optional<std::int64_t> peak_resident_bytes() {
  return proc_bytes("/proc/self/status", "VmHWM:");
}

}  // namespace geodesic::harness
