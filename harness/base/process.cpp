#include "harness/base/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <thread>

#include "harness/base/clock.h"
#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/base/plugins.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kKeptBytes = 4096;  // kept at the end of standard error
constexpr int kMostPauseMs = 50;          // a process that ends closes its standard error at once

[[noreturn]] void cannot_start(const std::string& program, int error) {
  throw HarnessError("cannot start " + program + ": " + std::strerror(error));
}

struct Pipe {
  int read = -1, write = -1;
  static Pipe make(const std::string& program) {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) cannot_start(program, errno);
    return {ends[0], ends[1]};
  }
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void limit(__rlimit_resource resource, std::uint64_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

// Runs in the child. Only calls that are allowed between fork and exec in a threaded program.
[[noreturn]] void become(char* const* argv, pid_t parent, int standard_error, int failure,
                         const ProcessLimits& limits) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, limits.signal_at_death);
  if (getppid() != parent) _exit(1);  // the parent died before that took effect
  limit(RLIMIT_CORE, 0);
  if (kLimitsMemory && limits.memory_bytes != RLIM_INFINITY) limit(RLIMIT_AS, limits.memory_bytes);
  const int null_device = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (null_device >= 0 && dup2(null_device, STDIN_FILENO) >= 0 &&
      dup2(null_device, STDOUT_FILENO) >= 0 && dup2(standard_error, STDERR_FILENO) >= 0) {
    execv(argv[0], argv);
  }
  const int error = errno;
  const ssize_t written = write(failure, &error, sizeof error);
  _exit(written > 0 ? 127 : 126);
}

// A child process and its process group. Neither outlives this object.
class Child {
 public:
  /// @throws HarnessError when the program cannot be started
  Child(const std::string& program, const std::vector<std::string>& arguments,
        const ProcessLimits& limits);
  /// Calls finish() unless it was called.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool has_ended() const;

  /// Reads its standard error, for a twentieth of a second at most.
  void listen(double most_seconds);

  struct Exit {
    int status;  ///< as waitpid gives it
    std::int64_t peak_resident_bytes;
    double cpu_seconds;
    std::int64_t involuntary_switches;
    std::string error_tail;  ///< the end of its standard error
  };
  /// Kills the process group, including the process if it still runs. Called once.
  Exit finish();

 private:
  void read_available();

  pid_t process_ = 0;
  int pipe_ = -1;  // its standard error; -1 after the other end was closed
  int pause_ms_ = 1;
  std::string tail_;
};

Child::Child(const std::string& program, const std::vector<std::string>& arguments,
             const ProcessLimits& limits) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = argv_of(words);

  const Pipe standard_error = Pipe::make(program);
  const Pipe failure = Pipe::make(program);  // closed by a successful exec
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    become(argv.data(), parent, standard_error.write, failure.write, limits);
  }
  int error = process_ < 0 ? errno : 0;
  close(standard_error.write);
  close(failure.write);
  pipe_ = standard_error.read;
  if (process_ > 0) {
    setpgid(process_, process_);  // parent and child both do this
    while (read(failure.read, &error, sizeof error) < 0 && errno == EINTR) {
    }
  }
  close(failure.read);
  if (error != 0) {
    if (process_ > 0) waitpid(process_, nullptr, 0);
    close(pipe_);
    cannot_start(program, error);
  }
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  if (process_ > 0) finish();
}

bool Child::has_ended() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == process_;
}

void Child::read_available() {
  std::array<char, kKeptBytes> block;
  const ssize_t bytes = read(pipe_, block.data(), block.size());
  if (bytes < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (bytes <= 0) {
    close(pipe_);
    pipe_ = -1;
    return;
  }
  tail_.append(block.data(), static_cast<std::size_t>(bytes));
  if (tail_.size() > kKeptBytes) tail_.erase(0, tail_.size() - kKeptBytes);
}

// A process that has closed its standard error has most likely ended; if not, the pauses grow.
void Child::listen(double most_seconds) {
  const int most_ms = static_cast<int>(std::clamp(1e3 * most_seconds, 1.0, 1.0 * kMostPauseMs));
  if (pipe_ < 0) {
    poll(nullptr, 0, std::min(pause_ms_, most_ms));
    pause_ms_ = std::min(2 * pause_ms_, kMostPauseMs);
    return;
  }
  pollfd readable{.fd = pipe_, .events = POLLIN, .revents = 0};
  if (poll(&readable, 1, most_ms) > 0) read_available();
}

// The group number is not reused before the process has been waited for.
Child::Exit Child::finish() {
  kill(-process_, SIGKILL);
  Exit exit{};
  rusage usage{};
  while (wait4(process_, &exit.status, 0, &usage) < 0 && errno == EINTR) {
  }
  process_ = 0;
  constexpr int kMostBlocks = 64;  // a full pipe; processes that left the group may still write
  for (int i = 0; i < kMostBlocks && pipe_ >= 0; ++i) read_available();
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  exit.peak_resident_bytes = std::int64_t{1024} * usage.ru_maxrss;
  exit.cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  exit.involuntary_switches = usage.ru_nivcsw;
  exit.error_tail = std::move(tail_);
  return exit;
}

constexpr std::size_t kKeptLines = 3;
constexpr double kCallSeconds = 1;  // between two calls of `waiting`

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

// A process that gets no memory crashes in various ways. The kernel kills a process without a
// message when the machine has no memory left.
bool ran_out_of_memory(const Ended& ended, std::int64_t peak_bytes, std::uint64_t limit) {
  if (!ended.crashed || ended.timed_out) return false;
  const bool near_limit = static_cast<double>(peak_bytes) > 0.9 * static_cast<double>(limit);
  return near_limit || ended.code == SIGKILL ||
         ended.error_lines.find("std::bad_alloc") != std::string::npos;
}

// Ticks of all processors since the machine started; 0 if there is no /proc.
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

// A scheduler that ends many processes at once may reach a child first. That is not a crash: the
// same signal then reaches this process within moments.
void throw_if_interrupted_soon() {
  constexpr int kSteps = 100;
  constexpr std::chrono::milliseconds kStep(10);
  for (int i = 0; i < kSteps; ++i) {
    throw_if_interrupted();
    std::this_thread::sleep_for(kStep);
  }
}

}  // namespace

std::vector<char*> argv_of(std::vector<std::string>& words) {
  std::vector<char*> argv(words.size() + 1, nullptr);
  std::ranges::transform(words, argv.begin(), [](std::string& word) { return word.data(); });
  return argv;
}

std::string Ended::describe() const {
  std::string text = crashed
                         ? "killed by signal " + std::to_string(code) + " (" + strsignal(code) + ")"
                         : "exit code " + std::to_string(code);
  return error_lines.empty() ? text : text + ": " + error_lines;
}

Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::function<void()>& waiting, const ProcessLimits& limits) {
  const Stopwatch watch;
  const Ticks before = Ticks::now();
  Child child(program.string(), arguments, limits);
  Ended ended;
  double called_seconds = 0;
  while (!child.has_ended()) {
    throw_if_interrupted();
    const double seconds = watch.real_seconds();
    if (seconds >= limits.seconds) {
      ended.timed_out = true;
      break;
    }
    if (seconds - called_seconds >= kCallSeconds) {
      waiting();
      called_seconds = seconds;
    }
    child.listen(limits.seconds - seconds);
  }
  const Child::Exit exit = child.finish();
  ended.crashed = WIFSIGNALED(exit.status);
  ended.code = ended.crashed ? WTERMSIG(exit.status) : WEXITSTATUS(exit.status);
  if (ended.crashed && std::ranges::count(InterruptionGuard::kSignals, ended.code) > 0) {
    throw_if_interrupted_soon();
  }
  ended.real_seconds = watch.real_seconds();
  ended.cpu_seconds = exit.cpu_seconds;
  ended.peak_resident_bytes = exit.peak_resident_bytes;
  ended.disturbance = disturbance_since(before, exit);
  ended.error_lines = last_lines(exit.error_tail);
  ended.out_of_memory = ran_out_of_memory(ended, exit.peak_resident_bytes, limits.memory_bytes);
  return ended;
}

Ended run_geodesic_bench(const std::vector<std::string>& arguments,
                         const std::function<void()>& waiting, const ProcessLimits& limits,
                         const std::filesystem::path& program) {
  std::vector<std::string> words = plugin_arguments();
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(program, words, waiting, limits);
}

}  // namespace geodesic::harness
