// A line on standard error for every cell, with an estimate of the time left; in between, what a
// long cell is at and for how long.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/base/clock.h"
#include "harness/cells/plan.h"

namespace geodesic::harness {

class Progress {
 public:
  explicit Progress(const std::vector<Cell>& cells);

  /// To be called about once a second while the next cell is worked on. On a terminal one line is
  /// kept up to date; elsewhere (a log) a line is written every minute.
  /// @param work what is being done: "reference by mmp"
  void working(const std::string& work);

  /// The next cell, in the order of the constructor's, has its result from an earlier start.
  void kept() { ++done_; }

  /// The next cell is not measured.
  void left_out() { ++done_; }

  /// The next cell has ended.
  /// @param result its outcome, and its time or what went wrong
  void ended(const std::string& result);

 private:
  double seconds_left() const;
  double seconds_in_cell() const { return watch_.real_seconds() - last_seconds_; }
  std::string heading() const;

  // A solver's pace on the meshes it has done so far; solvers differ by factors of a thousand.
  struct Pace {
    double seconds = 0, work = 0;
  };
  const std::vector<Cell>& cells_;
  std::size_t done_ = 0;
  std::map<std::string, Pace> paces_;  // by solver, and of all under ""
  double last_seconds_ = 0;            // when the last cell ended
  double told_seconds_ = 0;            // when a log was last written to
  const bool on_terminal_;
  Stopwatch watch_;
};

}  // namespace geodesic::harness
