// A line on standard error for every cell, with an estimate of the time left.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/cells/plan.h"
#include "harness/measure/process.h"

namespace geodesic::harness {

class Progress {
 public:
  explicit Progress(const std::vector<Cell>& cells) : cells_(cells) {}

  /// The next cell, in the order of the constructor's, has ended.
  /// @param result its outcome, and its time or what went wrong
  void ended(const std::string& result);

 private:
  double seconds_left() const;

  // A solver's pace on the meshes it has done so far; solvers differ by factors of a thousand.
  struct Pace {
    double seconds = 0, work = 0;
  };
  const std::vector<Cell>& cells_;
  std::size_t done_ = 0;
  std::map<std::string, Pace> paces_;  // by solver, and of all under ""
  double last_seconds_ = 0;
  Stopwatch watch_;
};

}  // namespace geodesic::harness
