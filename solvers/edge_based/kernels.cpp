// The kernels of AVX2, AVX-512 and all other processors (plain_lanes.h). Needs Google Highway.
#include "solvers/edge_based/kernels.h"

// The compiler does not know the size of SVE vectors, so structs cannot hold them.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
  (HWY_AVX3_DL | HWY_SSE4 | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/kernels-inl.h"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/kernels-inl.h"

namespace geodesic::edge_based {

namespace {

template <Carried carried>
const Kernels& compiled_kernels(InstructionSet set) {
  switch (set) {
#if (HWY_TARGETS & HWY_AVX3) != 0
    case InstructionSet::avx512:
      return N_AVX3::kKernels<carried>;
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0
    case InstructionSet::avx2:
      return N_AVX2::kKernels<carried>;
#endif
    default:
      return HWY_STATIC_DISPATCH(kKernels<carried>);
  }
}

}  // namespace

InstructionSet compiled_for(InstructionSet wanted) {
  const auto compiled = [](InstructionSet set) {
    return set == InstructionSet::plain
               ? HWY_STATIC_TARGET != HWY_AVX2 && HWY_STATIC_TARGET != HWY_AVX3
               : (HWY_TARGETS & (set == InstructionSet::avx2 ? HWY_AVX2 : HWY_AVX3)) != 0;
  };
  InstructionSet nearest = wanted;
  for (const InstructionSet set : kInstructionSets) {
    if (compiled(set) && (set <= wanted || !compiled(nearest))) nearest = set;
  }
  return nearest;
}

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
