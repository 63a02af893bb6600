// A recorded solve, compiled apart from timed ones.
#pragma once

#include <span>

#include "solvers/solver.h"

namespace geodesic::mmp {

/// As Solver::run. @tparam Order of orders.h
template <class Order>
void solve_recorded(const Mesh& mesh, const Query& query, std::span<double> distances,
                    Recording& recording);

}  // namespace geodesic::mmp
