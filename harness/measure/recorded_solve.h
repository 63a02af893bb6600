// One more solve that counts what the timed ones must not.
#pragma once

#include <span>
#include <string>

#include "harness/base/json.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Solves with counters on a fresh solver object, and once more on another to time the phases.
/// @param distances one entry a vertex, to be compared with those of the solve that was timed;
/// those
///        of the second recorded solve if they differ from the first one's
/// @return the solver's counters (results/counters.h), solver_peak_bytes (the most that preparation
///         and solve together had allocated), unreachable_vertices, and phase_seconds where the
///         solver has phases
Json record_solve(const std::string& solver, const Mesh& mesh, const Query& query,
                  std::span<double> distances);

/// True when both hold the same bits.
bool identical(std::span<const double> a, std::span<const double> b);

}  // namespace geodesic::harness
