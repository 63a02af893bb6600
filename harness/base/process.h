// Other processes, with limits of time and memory: above all this program, started again.
#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace geodesic::harness {

/// False in builds with sanitizers, which reserve more address space than any machine has memory,
/// handle some signals themselves, and are slow.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#elif defined(__has_feature)
inline constexpr bool kLimitsMemory =
    !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
inline constexpr bool kLimitsMemory = true;
#endif

struct ProcessLimits {
  double seconds = std::numeric_limits<double>::infinity();  ///< then the process is killed
  /// Of address space, enforced if `kLimitsMemory`.
  std::uint64_t memory_bytes = std::numeric_limits<std::uint64_t>::max();
  int signal_at_death = SIGKILL;  ///< that it gets when this process dies
};

/// Words as execv takes them, with a null pointer behind. They must outlive it.
std::vector<char*> argv_of(std::vector<std::string>& words);

/// Memory available for new processes together, in bytes: nine tenths of what Linux calls
/// available, or of what the control group of this process leaves where that is less.
std::uint64_t available_memory();

/// What else the machine did while a process ran.
struct Disturbance {
  /// Of all processors' time, 0 to 1, taken by the hypervisor; 0 where /proc/stat has counted no
  /// more than one tick (10 ms of one processor), which may have been any part of one.
  double stolen_share = 0;
  /// Involuntary context switches of the process for each second of its CPU time; less than 0.05 s
  /// count as 0.05 s.
  double involuntary_switches_per_s = 0;
};

struct Ended {
  bool crashed = false;        ///< by a signal
  bool timed_out = false;      ///< and was killed for it
  bool out_of_memory = false;  ///< crashed, and its memory had come to its limit or the machine's
  int code = 0;                ///< exit code, or the signal's number
  double real_seconds = 0;
  double cpu_seconds = 0;                ///< of it and of the processes that it waited for
  std::int64_t peak_resident_bytes = 0;  ///< of the largest of these
  Disturbance disturbance = {};
  std::string error_lines;  ///< the last lines of its standard error, joined by " | "

  bool succeeded() const { return !crashed && code == 0; }
  /// "killed by signal 11 (Segmentation fault): ...", "exit code 1: ..."
  std::string describe() const;
};

/// Runs a program and waits for it. Its standard input and output are /dev/null. It leads a process
/// group of its own: processes that it leaves behind are killed when it has ended, and it gets a
/// signal when this process dies.
/// @param waiting called about once a second until the process has ended
/// @throws HarnessError when the program cannot be started
/// @throws Interrupted (interruption.h), after the process has been killed
Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::function<void()>& waiting, const ProcessLimits& limits = {});

/// Runs this program, or another build of it, with the same plug-ins. As run_program.
Ended run_geodesic_bench(const std::vector<std::string>& arguments,
                         const std::function<void()>& waiting, const ProcessLimits& limits = {},
                         const std::filesystem::path& program = "/proc/self/exe");

}  // namespace geodesic::harness
