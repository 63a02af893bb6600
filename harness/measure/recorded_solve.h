// One more solve that counts what the timed ones must not.
#pragma once

#include <span>
#include <string>

#include "harness/json.h"
#include "solvers/solver.h"

namespace geodesic::harness {

/// Solves with recording on a fresh solver object.
/// @param distances one entry a vertex, to be compared with those of the solve that was timed
/// @return the solver's counters (results/counters.h), solver_peak_bytes (the most that preparation
///         and solve together had allocated) and unreachable_vertices
Json record_solve(const std::string& solver, const Mesh& mesh, const Query& query,
                  std::span<double> distances);

/// True when both hold the same bits.
bool identical(std::span<const double> a, std::span<const double> b);

}  // namespace geodesic::harness
