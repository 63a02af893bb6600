// One more solve, for the isolines.
#pragma once

#include <span>
#include <string>

#include "harness/recordings/isolines/isolines.h"

namespace geodesic::harness {

/// Solves on a fresh solver object and traces the isolines before its windows are gone.
/// @param solver one that keeps its windows (Description::final_windows)
/// @param levels ascending
/// @param distances one entry a vertex; those of an earlier solve, and then those of this one
Isolines solve_isolines(const std::string& solver, const Mesh& mesh, const Query& query,
                        std::span<const double> levels, std::span<double> distances);

}  // namespace geodesic::harness
