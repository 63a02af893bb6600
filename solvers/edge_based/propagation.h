// One solve of the edge-based algorithm, as seen from outside the instruction sets.
#pragma once

#include <span>

#include "solvers/core/recording.h"
#include "solvers/core/solver.h"

namespace geodesic::edge_based {

class Propagator {
 public:
  virtual ~Propagator() = default;
  /// As Solver::run.
  virtual void run(const Query& query, std::span<double> distances, Recording* recording) = 0;
};

}  // namespace geodesic::edge_based
