#include "harness/cells/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "harness/error.h"
#include "harness/measure/process.h"
#include "harness/plugins.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kKeptBytes = 4096;  // of standard error
constexpr std::size_t kKeptLines = 3;
constexpr int kWaitMs = 1000;

void check(int error) {
  if (error != 0) {
    throw HarnessError(std::string("cannot start a process: ") + std::strerror(error));
  }
}

struct FileActions {
  posix_spawn_file_actions_t actions;
  FileActions() { check(posix_spawn_file_actions_init(&actions)); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
};

pid_t spawn(const std::string& program, const std::vector<std::string>& arguments,
            int standard_error) {
  FileActions files;
  check(posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0));
  check(posix_spawn_file_actions_addopen(&files.actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0));
  check(posix_spawn_file_actions_adddup2(&files.actions, standard_error, STDERR_FILENO));
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  check(posix_spawn(&child, program.c_str(), &files.actions, nullptr, argv.data(), environ));
  return child;
}

// Until when a process may run.
class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds) {}

  bool exists() const { return std::isfinite(seconds_); }
  /// What is left, at most `most`; 0 when it is over.
  int milliseconds_left(int most) const {
    const double left = 1e3 * (seconds_ - watch_.real_seconds());
    return static_cast<int>(std::ceil(std::clamp<double>(left, 0, most)));
  }

 private:
  const Stopwatch watch_;
  double seconds_;
};

// Everything until the other end is closed, or the time is over; only the end of it is kept.
// @param waiting called at every pause of kWaitMs
std::string read_tail(int pipe, const std::function<void()>& waiting, const Deadline& deadline) {
  std::string tail;
  std::array<char, kKeptBytes> block;
  while (const int left_ms = deadline.milliseconds_left(kWaitMs)) {
    pollfd readable{.fd = pipe, .events = POLLIN, .revents = 0};
    if (poll(&readable, 1, left_ms) <= 0) {
      waiting();
      continue;
    }
    const ssize_t bytes = read(pipe, block.data(), block.size());
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes <= 0) break;
    tail.append(block.data(), static_cast<std::size_t>(bytes));
    if (tail.size() > kKeptBytes) tail.erase(0, tail.size() - kKeptBytes);
  }
  return tail;
}

// Waits for the child, which may run on though it has closed its standard error, and kills it when
// the time is over.
// @param status as waitpid gives it
// @return whether it ended by itself
bool wait_for(pid_t child, const Deadline& deadline, int& status) {
  constexpr int kNapMs = 1;
  for (;;) {
    const pid_t ended = waitpid(child, &status, deadline.exists() ? WNOHANG : 0);
    if (ended == child) return true;
    if (ended == 0 && deadline.milliseconds_left(kNapMs) == 0) break;
    if (ended == 0) poll(nullptr, 0, kNapMs);
  }
  kill(child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return false;
}

std::string last_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  if (lines.size() > kKeptLines) lines.erase(lines.begin(), lines.end() - kKeptLines);
  return join(lines, " | ");
}

}  // namespace

std::string Ended::describe() const {
  std::string text = crashed
                         ? "killed by signal " + std::to_string(code) + " (" + strsignal(code) + ")"
                         : "exit code " + std::to_string(code);
  return last_words.empty() ? text : text + ": " + last_words;
}

Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::function<void()>& waiting, double time_limit) {
  std::array<int, 2> ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0) check(errno);
  const Deadline deadline(time_limit);
  pid_t child = 0;
  try {
    child = spawn(program.string(), arguments, ends[1]);
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[1]);
  Ended ended;
  ended.last_words = last_lines(read_tail(ends[0], waiting, deadline));
  close(ends[0]);
  int status = 0;
  ended.timed_out = !wait_for(child, deadline, status);
  ended.crashed = WIFSIGNALED(status);
  ended.code = ended.crashed ? WTERMSIG(status) : WEXITSTATUS(status);
  return ended;
}

Ended run_this_program(const std::vector<std::string>& arguments,
                       const std::function<void()>& waiting, double time_limit) {
  std::vector<std::string> words = plugin_arguments();
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/proc/self/exe", words, waiting, time_limit);
}

}  // namespace geodesic::harness
