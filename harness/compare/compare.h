// Two finished runs, cell by cell: what got slower, what is counted differently, what is gone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/compare/statistics.h"
#include "harness/results/read.h"

namespace geodesic::harness {

/// A difference in time is resolved when the Mann-Whitney test gives at most this.
inline constexpr double kSignificance = 0.01;

/// Repetitions that either side of a cell needs for that: 2 / C(10, 5) = 0.008.
inline constexpr std::size_t kLeastRepetitions = 5;

struct TimeChange {
  double before = 0;  ///< median CPU time, ms
  double after = 0;
  double p = 1;  ///< of no difference

  double ratio() const { return after / before; }
  bool resolved() const { return p <= kSignificance; }
};

struct NumberChange {
  std::string name;
  double before = 0;
  double after = 0;

  double ratio() const { return after / before; }
};

struct CellChange {
  std::string name;
  std::string solver;
  std::string failed_before;  ///< outcome and message; empty when it was ok
  std::string failed_after;
  bool wrong_after = false;
  std::optional<TimeChange> time = {};
  std::vector<NumberChange> counters = {};  ///< those that differ
  std::optional<NumberChange> memory = {};  ///< solver_peak_bytes, of a cell that was ok twice

  bool lost() const { return failed_before.empty() && !failed_after.empty(); }
};

/// Geometric mean of the ratios of time, over the cells of a solver or ("all") of the file.
struct Overall {
  std::string of;
  std::size_t cells = 0;
  Interval ratio = {};

  bool resolved() const { return ratio.low > 1 || ratio.high < 1; }
};

struct Comparison {
  std::vector<CellChange> cells = {};  ///< in both files
  std::vector<Overall> overall = {};   ///< a solver each, "all" last; empty without times
  std::vector<std::string> only_before = {};
  std::vector<std::string> only_after = {};
  std::vector<std::string> notes = {};  ///< what to know about the two files

  std::size_t count_lost() const;
  std::size_t count_wrong() const;
};

/// @throws HarnessError when the files are of different corpora, have different meshes under one
///         name, or no cell in common
Comparison compare(const ResultFile& before, const ResultFile& after);

}  // namespace geodesic::harness
