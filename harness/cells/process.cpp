#include "harness/cells/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "harness/error.h"
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

// Everything until the other end is closed; only the end of it is kept.
std::string read_tail(int pipe, const std::function<void()>& waiting) {
  std::string tail;
  std::array<char, kKeptBytes> block;
  for (;;) {
    pollfd readable{.fd = pipe, .events = POLLIN, .revents = 0};
    if (poll(&readable, 1, kWaitMs) == 0) {
      waiting();
      continue;
    }
    const ssize_t bytes = read(pipe, block.data(), block.size());
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes <= 0) return tail;
    tail.append(block.data(), static_cast<std::size_t>(bytes));
    if (tail.size() > kKeptBytes) tail.erase(0, tail.size() - kKeptBytes);
  }
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
                  const std::function<void()>& waiting) {
  std::array<int, 2> ends;
  if (pipe2(ends.data(), O_CLOEXEC) != 0) check(errno);
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
  ended.last_words = last_lines(read_tail(ends[0], waiting));
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ended.crashed = WIFSIGNALED(status);
  ended.code = ended.crashed ? WTERMSIG(status) : WEXITSTATUS(status);
  return ended;
}

Ended run_this_program(const std::vector<std::string>& arguments,
                       const std::function<void()>& waiting) {
  std::vector<std::string> words;
  for (const Plugin& plugin : loaded_plugins()) {
    words.insert(words.end(), {"--plugin", plugin.file.string()});
  }
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/proc/self/exe", words, waiting);
}

}  // namespace geodesic::harness
