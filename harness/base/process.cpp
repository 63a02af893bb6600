#include "harness/base/process.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

#include "harness/base/child.h"
#include "harness/base/clock.h"
#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/base/plugins.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kKeptLines = 3;
constexpr double kPauseSeconds = 1;  // between two calls of `waiting`

std::string last_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) lines.push_back(harmless(std::string_view(text).substr(at, end - at)));
    at = end + 1;
  }
  if (lines.size() > kKeptLines) lines.erase(lines.begin(), lines.end() - kKeptLines);
  return join(lines, " | ");
}

// A process that is refused memory often crashes in its own way. The kernel, when the machine has
// none left, kills without a word.
bool ran_out_of_memory(const Ended& ended, std::int64_t peak_bytes, std::uint64_t limit) {
  if (!ended.crashed || ended.timed_out) return false;
  const bool near_limit = static_cast<double>(peak_bytes) > 0.9 * static_cast<double>(limit);
  return near_limit || ended.code == SIGKILL ||
         ended.last_words.find("std::bad_alloc") != std::string::npos;
}

// Of all processors since the start of the machine; 0 where there is no /proc.
struct Ticks {
  std::uint64_t stolen = 0, total = 0;
  static Ticks now() {
    constexpr int kStolen = 7;  // user nice system idle iowait irq softirq steal
    Ticks ticks;
    std::ifstream stat("/proc/stat");
    std::string cpu;
    stat >> cpu;
    for (int column = 0; column <= kStolen; ++column) {
      std::uint64_t count = 0;
      stat >> count;
      ticks.total += count;
      if (column == kStolen) ticks.stolen = count;
    }
    return ticks;
  }
};

Disturbance disturbance_since(const Ticks& before, const Child::Exit& exit) {
  constexpr double kLeastCpuSeconds = 0.05;
  const Ticks after = Ticks::now();
  Disturbance disturbance{.involuntary_switches_per_s =
                              static_cast<double>(exit.involuntary_switches) /
                              std::max(exit.cpu_seconds, kLeastCpuSeconds)};
  const std::uint64_t stolen = after.stolen - before.stolen;
  if (stolen > 1) {
    disturbance.stolen_share =
        static_cast<double>(stolen) / static_cast<double>(after.total - before.total);
  }
  return disturbance;
}

}  // namespace

std::string Ended::describe() const {
  std::string text = crashed
                         ? "killed by signal " + std::to_string(code) + " (" + strsignal(code) + ")"
                         : "exit code " + std::to_string(code);
  return last_words.empty() ? text : text + ": " + last_words;
}

Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::function<void()>& waiting, const ProcessLimits& limits) {
  const Stopwatch watch;
  const Ticks before = Ticks::now();
  Child child(program.string(), arguments, limits.memory_bytes);
  Ended ended;
  double told_seconds = 0;
  while (!child.has_ended()) {
    throw_if_interrupted();
    const double seconds = watch.real_seconds();
    if (seconds >= limits.seconds) {
      ended.timed_out = true;
      break;
    }
    if (seconds - told_seconds >= kPauseSeconds) {
      waiting();
      told_seconds = seconds;
    }
    child.listen(limits.seconds - seconds);
  }
  const Child::Exit exit = child.finish();
  ended.crashed = WIFSIGNALED(exit.status);
  ended.code = ended.crashed ? WTERMSIG(exit.status) : WEXITSTATUS(exit.status);
  ended.disturbance = disturbance_since(before, exit);
  ended.last_words = last_lines(exit.last_words);
  ended.out_of_memory = ran_out_of_memory(ended, exit.peak_resident_bytes, limits.memory_bytes);
  return ended;
}

Ended run_this_program(const std::vector<std::string>& arguments,
                       const std::function<void()>& waiting, const ProcessLimits& limits) {
  std::vector<std::string> words = plugin_arguments();
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/proc/self/exe", words, waiting, limits);
}

}  // namespace geodesic::harness
