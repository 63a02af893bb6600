// Time and memory of this process, from the operating system.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace geodesic::harness {

/// Wall time and the CPU time of all threads of this process, in seconds since the construction.
class Stopwatch {
 public:
  Stopwatch();
  double real_seconds() const;
  double cpu_seconds() const;

 private:
  double real_start_;
  double cpu_start_;
};

/// CPU time of the calling thread, in seconds since it began.
double thread_cpu_seconds();

/// Resets the peak of `peak_resident_bytes`, so that it excludes the memory for reading the mesh.
/// Has no effect where the kernel does not support it (Linux does).
void restart_peak_resident_bytes();

/// Largest resident set of this process in bytes: VmHWM of /proc/self/status. getrusage's ru_maxrss
/// is not used, because it starts from the peak of the process that spawned this one.
std::optional<std::int64_t> peak_resident_bytes();

/// The size in bytes after a key in a file like /proc/meminfo; empty if there is none.
std::optional<std::int64_t> proc_bytes(const char* file, const std::string& key);

}  // namespace geodesic::harness
