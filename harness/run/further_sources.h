// One object that solves from many sources, one after the other.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "harness/results/row.h"
#include "harness/verify/references.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

struct FurtherSolves {
  FurtherTimes times;
  std::optional<FurtherErrors> errors = {};  ///< empty without exact distances
  std::string wrong =
      {};  ///< the first answer that breaks the solver's promise, in one line; or empty
};

/// Solves from each source for all vertices, and again with the next source as the only target
/// (after the last one comes the first), where the solve stops.
/// @param sources at least one
/// @param exact the exact distances from each source; null: answers are not compared
FurtherSolves solve_further_sources(Solver& solver, std::span<const Index> sources,
                                    DistanceRows* exact);

}  // namespace geodesic::harness
