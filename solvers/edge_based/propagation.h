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

/// What runs when `wish` is wished for: the nearest that was compiled.
InstructionSet compiled_for(InstructionSet wish);

/// The loop for an instruction set that `compiled_for` gave.
std::unique_ptr<Propagator> make_timed(const Mesh& mesh, InstructionSet set);
std::unique_ptr<Propagator> make_recorded(const Mesh& mesh, InstructionSet set, Record what);

}  // namespace geodesic::edge_based
