// The kernels of AVX2 beside those of every other processor (plain_lanes.h). Needs Google Highway.
#include "solvers/edge_based/kernels.h"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/kernels-inl.h"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/kernels-inl.h"

/// Whether there is an AVX2 version beside the one for every processor of the build.
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
#define GEODESIC_AVX2_BESIDE_STATIC 1
#else
#define GEODESIC_AVX2_BESIDE_STATIC 0
#endif

namespace geodesic::edge_based {

InstructionSet compiled_for(InstructionSet wanted) {
  if (HWY_STATIC_TARGET == HWY_AVX2) return InstructionSet::avx2;
  return GEODESIC_AVX2_BESIDE_STATIC ? wanted : InstructionSet::plain;
}

namespace {

template <Carried carried>
const Kernels& compiled_kernels(InstructionSet set) {
#if GEODESIC_AVX2_BESIDE_STATIC
  if (set == InstructionSet::avx2) return N_AVX2::kKernels<carried>;
#endif
  static_cast<void>(set);
  return HWY_STATIC_DISPATCH(kKernels<carried>);
}

}  // namespace

const Kernels& kernels_of(InstructionSet set, Carried carried) {
  switch (carried) {
    case Carried::nothing:
      return compiled_kernels<Carried::nothing>(set);
    case Carried::depth:
      return compiled_kernels<Carried::depth>(set);
    default:
      return compiled_kernels<Carried::root>(set);
  }
}

}  // namespace geodesic::edge_based
