// The loop (propagation-inl.h) for AVX2 and for every other processor (plain_lanes.h). To be
// included before anything else of Highway's. Needs Google Highway.
#pragma once

#include <memory>

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/propagation-inl.h"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/propagation-inl.h"

/// Whether there is an AVX2 version beside the one for every processor of the build.
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
#define GEODESIC_AVX2_BESIDE_STATIC 1
#else
#define GEODESIC_AVX2_BESIDE_STATIC 0
#endif

namespace geodesic::edge_based {

/// @param set AVX2 only when it was compiled
template <class Policy, class Recorder>
std::unique_ptr<Propagator> make_loop(const Mesh& mesh, InstructionSet set) {
#if GEODESIC_AVX2_BESIDE_STATIC
  if (set == InstructionSet::avx2) {
    return std::make_unique<N_AVX2::Propagation<Policy, Recorder>>(mesh);
  }
#endif
  static_cast<void>(set);
  return std::make_unique < HWY_STATIC_DISPATCH(Propagation) < Policy, Recorder >> (mesh);
}

}  // namespace geodesic::edge_based
