// A recorded solve, compiled apart from timed ones.
#pragma once

#include <span>

#include "solvers/solver.h"

namespace geodesic::chen_han {

/// As Solver::run. @tparam Policy of policies.h
template <class Policy>
void solve_recorded(const Mesh& mesh, const Query& query, std::span<double> distances,
                    Recording& recording);

}  // namespace geodesic::chen_han
