// The loop as recorded solves run it, compiled apart from the timed one.
#pragma once

#include <memory>

#include "solvers/edge_based/propagation.h"

namespace geodesic::edge_based {

/// Defined in recorded-inl.h. @tparam Policy of policies.h
template <class Policy>
struct Recorded {
  /// The loop for an instruction set that `make_loop` (loops.h) takes: with counters, with
  /// clocks, or with samples of the wavefront.
  static std::unique_ptr<Propagator> make(const Mesh& mesh, InstructionSet set, Record what);
};

}  // namespace geodesic::edge_based
