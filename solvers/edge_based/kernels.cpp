// The kernels of AVX2, AVX-512 and all other processors. Needs Google Highway.
#include "solvers/edge_based/kernels.h"

#include "solvers/edge_based/plain_kernels.h"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_AVX3_DL  // here it is AVX-512, as in core/instruction_set.cpp

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
      return plain::kKernels;
  }
}

}  // namespace

InstructionSet compiled_for(InstructionSet wanted) {
  const auto compiled = [](InstructionSet set) {
    return set == InstructionSet::plain ||
           (HWY_TARGETS & (set == InstructionSet::avx2 ? HWY_AVX2 : HWY_AVX3)) != 0;
  };
  InstructionSet nearest = InstructionSet::plain;
  for (const InstructionSet set : kInstructionSets) {
    if (compiled(set) && set <= wanted) nearest = set;
  }
  return nearest;
}

const Kernels& kernels_of(InstructionSet set, Carried carried) {
  switch (carried) {
    case Carried::nothing:
      return compiled_kernels<Carried::nothing>(set);
    case Carried::root:
      return compiled_kernels<Carried::root>(set);
    default:
      return compiled_kernels<Carried::depth>(set);
  }
}

}  // namespace geodesic::edge_based
