// The family edge-based as solvers: the propagation (propagation-inl.h) with a policy
// (propagation.h), compiled for AVX2 and for every other processor (plain_lanes.h).
//
// To be included before anything else of Highway's. Needs Google Highway.
#pragma once

#include <concepts>
#include <memory>

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/propagation-inl.h"
#include <hwy/foreach_target.h>

#include "solvers/core/registry.h"
#include "solvers/edge_based/propagation-inl.h"

/// Whether there is an AVX2 version beside the one for every processor of the build.
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
#define GEODESIC_AVX2_BESIDE_STATIC 1
#else
#define GEODESIC_AVX2_BESIDE_STATIC 0
#endif

namespace geodesic::edge_based {

/// That of `edge-based`, compiled once, with it (edge_based.cpp).
template <class Recorder>
std::unique_ptr<Propagator<Recorder>> make_exact_propagator(const Mesh& mesh, InstructionSet set);

/// @param set AVX2 only when it was compiled
template <class Policy, class Recorder>
std::unique_ptr<Propagator<Recorder>> make_propagator(const Mesh& mesh, InstructionSet set,
                                                      const Policy& policy) {
  if constexpr (Policy::kMerges) {
    if (policy.shortfall() == 0) return make_exact_propagator<Recorder>(mesh, set);
  }
#if GEODESIC_AVX2_BESIDE_STATIC
  if (set == InstructionSet::avx2) {
    return std::make_unique<N_AVX2::Propagation<Policy, Recorder>>(mesh, policy);
  }
#endif
  static_cast<void>(set);
  return std::make_unique < HWY_STATIC_DISPATCH(Propagation) < Policy, Recorder >> (mesh, policy);
}

template <class Policy>
class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        policy_(policy_of(description)),
        instruction_set_(compiled_for(geodesic::instruction_set())),
        timed_(make_propagator<Policy, NoRecorder>(mesh, instruction_set_, policy_)) {}

  InstructionSet instruction_set() const override { return instruction_set_; }

  /// A recorded solve, compiled apart (core/recorders.h).
  /// @param set that make_propagator takes
  static void record(const Mesh& mesh, InstructionSet set, const Policy& policy, const Query& query,
                     std::span<double> distances, Recording& recording);

 private:
  static Policy policy_of(const Description& description) {
    if constexpr (std::constructible_from<Policy, const Description&>) {
      return Policy(description);
    } else {
      return {};
    }
  }

  /// The instruction set nearest to `wanted` that was compiled.
  static InstructionSet compiled_for(InstructionSet wanted) {
    if (HWY_STATIC_TARGET == HWY_AVX2) return InstructionSet::avx2;
    return GEODESIC_AVX2_BESIDE_STATIC ? wanted : InstructionSet::plain;
  }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return timed_->run(query, distances, NoRecorder());
    record(mesh(), instruction_set_, policy_, query, distances, *recording);
  }

  Policy policy_;
  InstructionSet instruction_set_;
  std::unique_ptr<Propagator<NoRecorder>> timed_;
};

#ifdef GEODESIC_RECORDED
template <class Policy>
[[gnu::used]] void EdgeBased<Policy>::record(const Mesh& mesh, InstructionSet set,
                                             const Policy& policy, const Query& query,
                                             std::span<double> distances, Recording& recording) {
  solve_recording(mesh, query, distances, recording, [&](auto recorder) {
    make_propagator<Policy, decltype(recorder)>(mesh, set, policy)->run(query, distances, recorder);
  });
}
#endif

}  // namespace geodesic::edge_based
