// Solves beside the timed ones: their counters, memory and phases.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "harness/results/row.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

struct RecordedSolve {
  Counters counters;
  std::optional<PhaseSeconds> phases;  ///< absent where the solver does not measure its phases
  std::int64_t peak_bytes = 0;  ///< the most that preparation and solve together had allocated
};

/// Solves with counters on a new solver object, and where the solver has counters on others to time
/// the phases.
/// @param distances one entry a vertex, to be compared with those of the timed solve; those of the
///        solve with phase timers if they differ from those of the solve with counters
RecordedSolve record_solve(const std::string& solver, const Mesh& mesh, const Query& query,
                           std::span<double> distances);

/// Subtracts the cost of reading the clock from phase times. A reading costs what the solve took
/// longer with timers, divided by all readings.
/// @param untimed wall seconds of the same solve without timers
PhaseSeconds phase_seconds(const PhaseTimes& times, double untimed);

/// True when both hold the same bits.
bool identical(std::span<const double> a, std::span<const double> b);

}  // namespace geodesic::harness
