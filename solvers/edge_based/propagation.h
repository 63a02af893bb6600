// One solve of the edge-based algorithm, as seen from outside the instruction sets.
#pragma once

#include <memory>
#include <span>

#include "solvers/core/instruction_set.h"
#include "solvers/core/recording.h"
#include "solvers/solver.h"

namespace geodesic::edge_based {

class Propagator {
 public:
  virtual ~Propagator() = default;
  /// As Solver::run.
  virtual void run(const Query& query, std::span<double> distances, Recording* recording) = 0;
};

/// The loop as compiled for one instruction set.
struct Path {
  InstructionSet instruction_set;
  std::unique_ptr<Propagator> (*make_timed)(const Mesh& mesh);
  std::unique_ptr<Propagator> (*make_recorded)(const Mesh& mesh, Record what);
};

}  // namespace geodesic::edge_based
