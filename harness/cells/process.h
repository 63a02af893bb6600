// Other processes: above all this program, started again.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace geodesic::harness {

struct Ended {
  bool crashed = false;    ///< by a signal
  bool timed_out = false;  ///< and was killed for it
  int code = 0;            ///< exit code, or the signal's number
  std::string last_words;  ///< the last lines of its standard error, joined by " | "

  bool succeeded() const { return !crashed && code == 0; }
  /// "killed by signal 11 (Segmentation fault): ...", "exit code 1: ..."
  std::string describe() const;
};

/// Runs a program and waits for it. Standard input and output are closed to it.
/// @param waiting called about once a second until the process has ended
/// @param time_limit seconds after which the process is killed
/// @throws HarnessError when no process can be started
Ended run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                  const std::function<void()>& waiting,
                  double time_limit = std::numeric_limits<double>::infinity());

/// Runs this very program with other arguments and the same plug-ins. As run_program.
Ended run_this_program(const std::vector<std::string>& arguments,
                       const std::function<void()>& waiting,
                       double time_limit = std::numeric_limits<double>::infinity());

}  // namespace geodesic::harness
