// The loop as timed solves run it. Apart from recorded.cpp, so that what the compiler inlines here
// does not depend on instrumentation: a timed solve takes 3% more instructions in one file with it.
#include "solvers/edge_based/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/timed.cpp"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/propagation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace geodesic::edge_based::HWY_NAMESPACE {
namespace {

std::unique_ptr<Propagator> timed(const Mesh& mesh) {
  return std::make_unique<Propagation<NoRecorder>>(mesh);
}

}  // namespace
}  // namespace geodesic::edge_based::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace geodesic::edge_based {

InstructionSet compiled_for(InstructionSet wish) {
  if (HWY_STATIC_TARGET == HWY_AVX2) return InstructionSet::avx2;
  return GEODESIC_AVX2_BESIDE_STATIC ? wish : InstructionSet::plain;
}

std::unique_ptr<Propagator> make_timed(const Mesh& mesh, InstructionSet set) {
#if GEODESIC_AVX2_BESIDE_STATIC
  if (set == InstructionSet::avx2) return N_AVX2::timed(mesh);
#endif
  static_cast<void>(set);
  return HWY_STATIC_DISPATCH(timed)(mesh);
}

}  // namespace geodesic::edge_based
#endif
