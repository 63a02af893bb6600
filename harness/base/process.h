// Starts other processes, above all this program again, with limits of time and memory.
#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace geodesic::harness {

/// False in builds with sanitizers. They reserve more address space than any machine has memory,
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
  double seconds = std::numeric_limits<double>::infinity();  ///< the process is then killed
  /// Limit of the address space, enforced if `kLimitsMemory`.
  std::uint64_t memory_bytes = std::numeric_limits<std::uint64_t>::max();
  int signal_at_death = SIGKILL;  ///< sent to the process when this process dies
};

/// Words in the form of execv, with a null pointer at the end. The words must outlive the result.
std::vector<char*> argv_of(std::vector<std::string>& words);

/// Effects of the rest of the machine on a process.
struct Disturbance {
  /// Share of all processors' time that the hypervisor took, 0 to 1. It is 0 if /proc/stat counted
  /// at most one tick (10 ms of one processor), because any part of a tick may count as one.
  double stolen_share = 0;
  /// Involuntary context switches of the process for each second of its CPU time. A time below
  /// 0.05 s counts as 0.05 s.
  double involuntary_switches_per_s = 0;
};

struct Ended {
  bool crashed = false;        ///< ended by a signal
  bool timed_out = false;      ///< killed at the time limit
  bool out_of_memory = false;  ///< crashed at its memory limit or the machine's
  int code = 0;                ///< exit code, or the signal's number
  double real_seconds = 0;
  double cpu_seconds = 0;                ///< of it and of the child processes that it waited for
  std::int64_t peak_resident_bytes = 0;  ///< of the largest of these processes
  Disturbance disturbance = {};
  std::string error_lines;  ///< the last lines of its standard error, joined by " | "

  bool succeeded() const { return !crashed && code == 0; }
  /// The end in words: "killed by signal 11 (Segmentation fault): ...", "exit code 1: ..."
  std::string describe() const;
};

/// Runs a program and waits for it. Its standard input and output are /dev/null. It leads its own
/// process group. Processes that it leaves behind are killed after its end. It gets a signal when
/// this process dies.
/// @param waiting called about once a second until the process has ended
/// @throws HarnessError when the program cannot be started
/// @throws Interrupted (interruption.h), after the process has been killed
Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::function<void()>& waiting, const ProcessLimits& limits = {});

/// Runs this program, or another build of it, with the same plug-ins. Otherwise like run_program.
Ended run_geodesic_bench(const std::vector<std::string>& arguments,
                         const std::function<void()>& waiting, const ProcessLimits& limits = {},
                         const std::filesystem::path& program = "/proc/self/exe");

}  // namespace geodesic::harness
