// Where the time of a solve goes, without what finding out takes.
#pragma once

#include <optional>
#include <string>

#include "harness/base/json.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Takes the readings of the clock out of phase times. What a reading really costs beside other
/// work is what the solve took longer for having timers, divided among all readings; it is never
/// more than a reading costs alone.
/// @param untimed wall seconds of the same solve without timers
/// @return seconds: propagation, trimming, queue, and timer_overhead, what was taken out of them
Json phase_seconds(const PhaseTimes& times, double untimed);

/// Solves three times on fresh solver objects, the second time with timers; a solve of seconds only
/// twice.
/// @param distances what the solve with timers gave
/// @return nothing when the solver does not tell its phases
std::optional<Json> time_phases(const std::string& solver, const Mesh& mesh, const Query& query,
                                std::span<double> distances);

}  // namespace geodesic::harness
