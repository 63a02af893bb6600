// Writes a line on standard error for every cell, with an estimate of the time left. Shows the
// current work of a long cell and its time so far.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/base/clock.h"
#include "harness/base/status_line.h"
#include "harness/run/plan.h"

namespace geodesic::harness {

/// Estimates how long cells take: from the solvers' relative times and the sizes of the meshes,
/// corrected by the cells that have been measured.
class Forecast {
 public:
  /// @param cells must outlive it
  /// @param solvers that can give reference distances
  Forecast(const std::vector<Cell>& cells, const Suite& suite,
           const std::vector<const Description*>& solvers);

  void measured(std::size_t cell, double seconds);
  /// Seconds for this cell and the cells after it.
  double seconds_left(std::size_t first) const;

 private:
  struct Expected {
    double fixed = 0;                        // seconds that do not depend on the solver
    double solves = 0;                       // seconds at the assumed speed
    const Description* reference = nullptr;  // null: already computed, or a closed form
    double reference_solve = 0;              // seconds at the assumed speed
  };
  struct Pace {
    double seconds = 0, expected = 0;  // of solves measured so far
  };
  double pace_of(const Description& solver) const;

  const std::vector<Cell>& cells_;
  std::vector<Expected> expected_;            // by cell
  Pace all_;                                  // of solvers whose relative time is known
  std::map<const Description*, Pace> paces_;  // of each solver
};

class Progress {
 public:
  /// @param cells must outlive it
  Progress(const std::vector<Cell>& cells, const Suite& suite);

  /// Must be called about once a second during the next cell. Updates one line on a terminal, and
  /// writes a line every minute elsewhere (a log).
  /// @param work current work: "reference by mmp"
  void working(const std::string& work);

  /// Skips the next cell, in the order of the constructor's cells.
  void leave_out() { ++done_; }

  /// The next cell has ended.
  /// @param result its outcome, and its time or the error
  void ended(const std::string& result);

 private:
  double seconds_in_cell() const { return watch_.real_seconds() - last_seconds_; }
  std::string heading() const;

  const std::vector<Cell>& cells_;
  std::size_t done_ = 0;
  Forecast forecast_;
  double last_seconds_ = 0;  // when the last cell ended
  StatusLine line_;
  Stopwatch watch_;
};

}  // namespace geodesic::harness
