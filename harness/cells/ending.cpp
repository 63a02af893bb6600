#include "harness/cells/ending.h"

#include <iostream>
#include <new>

#include "harness/base/error.h"
#include "harness/results/outcome.h"
#include "meshes/messages.h"

namespace geodesic::harness {
namespace {

// Beside 0 and 1; 2 is the program's own for a wrong answer.
constexpr int kOutOfMemory = 3;
constexpr int kCannotWrite = 4;

std::string in_mib(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

}  // namespace

int exit_code_of(const std::function<void()>& work) {
  try {
    work();
    return 0;
  } catch (const std::bad_alloc& error) {
    std::cerr << "no memory left" << std::endl;
    return kOutOfMemory;
  } catch (const CannotWrite& error) {
    std::cerr << error.what() << std::endl;
    return kCannotWrite;
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}

Failure failure_of(const Ended& ended, const ProcessLimits& limits) {
  const std::string words = ended.last_words.empty() ? "" : ": " + ended.last_words;
  if (ended.timed_out) {
    return {outcome::kTimeOut,
            "not finished after " + significant(limits.seconds, 6) + " s (time limit)" + words};
  }
  if (!ended.crashed && ended.code == kCannotWrite) throw CannotWrite(ended.last_words);
  if (ended.out_of_memory || (!ended.crashed && ended.code == kOutOfMemory)) {
    const std::string limit = limits.memory_bytes == ProcessLimits().memory_bytes
                                  ? "no memory left"
                                  : "memory limit " + in_mib(limits.memory_bytes);
    return {outcome::kOutOfMemory, ended.crashed ? limit + ", " + ended.describe() : limit};
  }
  return {ended.crashed ? outcome::kCrashed : outcome::kError, ended.describe()};
}

ProcessLimits limits_of(const Suite& suite) {
  ProcessLimits limits{.seconds = suite.time_limit};
  if (suite.memory_limit) limits.memory_bytes = *suite.memory_limit;
  return limits;
}

void set_memory_limit(Suite& suite, unsigned processes) {
  if (!suite.memory_limit) suite.memory_limit = memory_to_give() / processes;
}

}  // namespace geodesic::harness
