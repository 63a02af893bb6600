// A recorded solve, compiled apart from timed ones.
#pragma once

#include <span>

#include "solvers/core/solver.h"

namespace geodesic::chen_han {

/// Defined in recorded-inl.h. @tparam Policy of policies.h
template <class Policy>
struct Recorded {
  /// As Solver::run.
  static void solve(const Mesh& mesh, const Query& query, std::span<double> distances,
                    Recording& recording);
};

}  // namespace geodesic::chen_han
