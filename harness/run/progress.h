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

/// Estimates how long cells take: by their work, the number of solves times a power of the mesh's
/// vertices, and the pace of each solver in its last cells.
class Forecast {
 public:
  /// @param cells must outlive it
  Forecast(const std::vector<Cell>& cells, const Suite& suite);

  void measured(std::size_t cell, double seconds);
  /// Seconds for this cell and the cells after it.
  double seconds_left(std::size_t first) const;

 private:
  struct Expected {
    double least = 0;  // seconds that any solver takes
    double work = 0;
  };
  struct Pace {
    double seconds = 0, work = 0;  // of cells, less of earlier ones
  };
  /// Seconds per unit of work; of a solver without a measured cell, the mean of the others.
  double pace_of(const Description& solver) const;

  const std::vector<Cell>& cells_;
  std::vector<Expected> expected_;  // by cell
  std::map<const Description*, Pace> paces_;
};

class CellLines {
 public:
  /// @param cells must outlive it
  CellLines(const std::vector<Cell>& cells, const Suite& suite);

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
