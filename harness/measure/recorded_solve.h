// Solves in addition to the timed ones, for counters, memory and phases.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "harness/results/row.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

struct RecordedSolve {
  Counters counters;
  std::optional<PhaseSeconds> phases;  ///< empty if the solver does not measure its phases
  std::int64_t peak_bytes = 0;         ///< peak of allocations in preparation and solve
};

/// Solves with counters on a new solver object. If the solver has counters, other objects then time
/// the phases.
/// @param distances one for each vertex, to compare with the timed solve. They are those of the
///        solve with phase timers if these differ from those of the solve with counters
RecordedSolve record_solve(const std::string& solver, const Mesh& mesh, const Query& query,
                           std::span<double> distances);

/// Subtracts the cost of reading the clock from phase times. The cost of one reading is the extra
/// time of the solve with timers, divided by the number of readings.
/// @param untimed wall seconds of the same solve without timers
PhaseSeconds phase_seconds(const PhaseTimes& times, double untimed);

/// Whether both hold the same bits.
bool identical(std::span<const double> a, std::span<const double> b);

}  // namespace geodesic::harness
