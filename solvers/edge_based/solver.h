// The family edge-based as a solver; what its members differ in is a policy (policies.h).
// Needs Google Highway.
#pragma once

#include "solvers/core/instruction_set.h"
#include "solvers/core/solver.h"
#include "solvers/edge_based/loops.h"
#include "solvers/edge_based/recorded.h"

namespace geodesic::edge_based {

/// Needs Recorded<Policy>, which the file recorded.cpp of the solver's folder instantiates.
template <class Policy>
class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        instruction_set_(compiled_for(geodesic::instruction_set())),
        timed_(make_loop<Policy, NoRecorder>(mesh, instruction_set_)) {}

  InstructionSet instruction_set() const override { return instruction_set_; }

 private:
  /// What runs when `wish` is wished for: the nearest that was compiled.
  static InstructionSet compiled_for(InstructionSet wish) {
    if (HWY_STATIC_TARGET == HWY_AVX2) return InstructionSet::avx2;
    return GEODESIC_AVX2_BESIDE_STATIC ? wish : InstructionSet::plain;
  }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) {
      timed_->run(query, distances, nullptr);
    } else {
      Recorded<Policy>::make(mesh(), instruction_set_, recording->what)
          ->run(query, distances, recording);
    }
  }

  InstructionSet instruction_set_;
  std::unique_ptr<Propagator> timed_;
};

}  // namespace geodesic::edge_based
