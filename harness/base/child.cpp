#include "harness/base/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kKeptBytes = 4096;  // of standard error
constexpr int kMostNapMs = 50;            // a process that ends closes its standard error at once

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

// In the child; only what is allowed between fork and exec in a program with threads.
[[noreturn]] void become(char* const* argv, pid_t parent, int standard_error, int failure,
                         std::uint64_t memory_bytes) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it died before that took effect
  limit(RLIMIT_CORE, 0);
  if (kLimitsMemory && memory_bytes != RLIM_INFINITY) limit(RLIMIT_AS, memory_bytes);
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(nothing, STDOUT_FILENO) >= 0 &&
      dup2(standard_error, STDERR_FILENO) >= 0) {
    execv(argv[0], argv);
  }
  const int error = errno;
  const ssize_t told = write(failure, &error, sizeof error);
  _exit(told > 0 ? 127 : 126);
}

}  // namespace

Child::Child(const std::string& program, const std::vector<std::string>& arguments,
             std::uint64_t memory_bytes) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const Pipe standard_error = Pipe::make(program);
  const Pipe failure = Pipe::make(program);  // closed by a successful exec
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    become(argv.data(), parent, standard_error.write, failure.write, memory_bytes);
  }
  int error = process_ < 0 ? errno : 0;
  close(standard_error.write);
  close(failure.write);
  pipe_ = standard_error.read;
  if (process_ > 0) {
    setpgid(process_, process_);  // whoever of the two comes first
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

void Child::read_what_there_is() {
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

// Once its standard error is closed it has most likely ended, or it wants to be alone: naps grow.
void Child::listen(double most_seconds) {
  const int most_ms = static_cast<int>(std::clamp(1e3 * most_seconds, 1.0, 1.0 * kMostNapMs));
  if (pipe_ < 0) {
    poll(nullptr, 0, std::min(nap_ms_, most_ms));
    nap_ms_ = std::min(2 * nap_ms_, kMostNapMs);
    return;
  }
  pollfd readable{.fd = pipe_, .events = POLLIN, .revents = 0};
  if (poll(&readable, 1, most_ms) > 0) read_what_there_is();
}

// Its group cannot be another's as long as it has not been waited for.
Child::Exit Child::finish() {
  kill(-process_, SIGKILL);
  Exit exit{};
  rusage usage{};
  while (wait4(process_, &exit.status, 0, &usage) < 0 && errno == EINTR) {
  }
  process_ = 0;
  constexpr int kMostBlocks = 64;  // a pipe holds no more; what left the group may write on
  for (int i = 0; i < kMostBlocks && pipe_ >= 0; ++i) read_what_there_is();
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  exit.peak_resident_bytes = std::int64_t{1024} * usage.ru_maxrss;
  exit.cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  exit.involuntary_switches = usage.ru_nivcsw;
  exit.last_words = std::move(tail_);
  return exit;
}

}  // namespace geodesic::harness
