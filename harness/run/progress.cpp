#include "harness/run/progress.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "harness/corpus/solvers.h"
#include "harness/verify/references.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

// Priors of the forecast, from runs of the corpora quick and real; measured paces replace them.
constexpr double kProcessSeconds = 0.1;
constexpr double kFastestSeconds = 0.1;  // a solve of relative time 1 on 50,000 vertices
constexpr double kUnknownRelativeTime = 10;
constexpr double kGrowth = 1.3;       // exponent of the vertex count: 1.1 to 1.5 by solver
constexpr double kSearchShare = 0.5;  // of min_time, for finding the number of iterations
constexpr double kMachineWeight = 1, kSolverWeight = 0.5;  // of priors, in expected seconds

double expected_solve_seconds(const Description& solver, Index vertices) {
  const double known = relative_time(solver), relative = known > 0 ? known : kUnknownRelativeTime;
  return kFastestSeconds * relative * std::pow(vertices / 5e4, kGrowth);
}

}  // namespace

Forecast::Forecast(const std::vector<Cell>& cells, const Suite& suite,
                   const std::vector<const Description*>& solvers)
    : cells_(cells) {
  std::set<std::tuple<const PlannedMesh*, const SourceSet*, const Description*>> references;
  for (const Cell& cell : cells) {
    Expected& expected = expected_.emplace_back();
    if (cell.unsupported() != nullptr) continue;
    const double solve = expected_solve_seconds(*cell.solver, cell.mesh->vertices);
    const int repetitions = cell.repetition < 0 ? suite.repetitions : 1;
    // The warm-up solve, and four more for counters and phases.
    expected.solves = solve * (cell.is_first_repetition() ? 5 : 1);
    expected.fixed = kProcessSeconds;
    if (solve < suite.min_time) {
      expected.fixed += repetitions * suite.min_time * (1 + kSearchShare);
    } else {
      expected.solves += repetitions * solve;
    }
    if (has_closed_form(cell.mesh->entry)) continue;
    for (const Description* reference : rank_references(*cell.solver, solvers, suite.reference)) {
      if (cell.mesh->unsupported_by(reference->name, *cell.source) != nullptr) continue;
      if (references.insert({cell.mesh, cell.source, reference}).second) {
        expected.reference = reference;
        expected.reference_solve = expected_solve_seconds(*reference, cell.mesh->vertices);
      }
      break;
    }
  }
}

double Forecast::pace_of(const Description& solver) const {
  const double machine = (all_.seconds + kMachineWeight) / (all_.expected + kMachineWeight);
  const auto pace = paces_.find(&solver);
  if (pace == paces_.end()) return machine;
  return (pace->second.seconds + kSolverWeight * machine) / (pace->second.expected + kSolverWeight);
}

void Forecast::measured(std::size_t cell, double seconds) {
  const Expected& expected = expected_[cell];
  const Description& solver = *cells_[cell].solver;
  if (expected.solves == 0) return;
  if (expected.reference != nullptr) {
    seconds -= expected.reference_solve * pace_of(*expected.reference);
  }
  const auto add = [&](Pace& pace) {
    pace.seconds += std::max(0.0, seconds - expected.fixed);
    pace.expected += expected.solves;
  };
  add(paces_[&solver]);
  if (relative_time(solver) > 0) add(all_);
}

double Forecast::seconds_left(std::size_t first) const {
  double seconds = 0;
  for (std::size_t i = first; i < cells_.size(); ++i) {
    const Expected& expected = expected_[i];
    seconds += expected.fixed + expected.solves * pace_of(*cells_[i].solver);
    if (expected.reference != nullptr) {
      seconds += expected.reference_solve * pace_of(*expected.reference);
    }
  }
  return seconds;
}

Progress::Progress(const std::vector<Cell>& cells, const Suite& suite)
    : cells_(cells), forecast_(cells, suite, registered_solvers()) {}

// "[3/40] mmp/horse/src:0  "
std::string Progress::heading() const {
  const Cell& cell = cells_[done_];
  std::string text =
      "[" + std::to_string(done_ + 1) + "/" + std::to_string(cells_.size()) + "] " + cell.name();
  if (cell.repetition >= 0) text += " repetition " + std::to_string(cell.repetition);
  if (cell.program != nullptr) text += " by " + cell.program->name;
  return text + "  ";
}

void Progress::working(const std::string& work) {
  line_.show(heading() + work + ", " + duration(seconds_in_cell()) + " so far");
}

void Progress::ended(const std::string& result) {
  std::string text = heading() + result;
  const double seconds = seconds_in_cell();
  forecast_.measured(done_++, seconds);
  last_seconds_ += seconds;
  text += "  (" + duration(seconds);
  if (done_ < cells_.size()) {
    text += ", about " + duration(forecast_.seconds_left(done_)) + " left";
  }
  line_.write(text + ')');
}

}  // namespace geodesic::harness
