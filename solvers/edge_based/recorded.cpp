// The loop as recorded solves run it, with counters, with clocks, or with samples of the wavefront.
#include "solvers/edge_based/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/recorded.cpp"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/propagation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace geodesic::edge_based::HWY_NAMESPACE {
namespace {

std::unique_ptr<Propagator> recorded(const Mesh& mesh, Record what) {
  switch (what) {
    case Record::counters:
      return std::make_unique<Propagation<CountingRecorder>>(mesh);
    case Record::phase_times:
      return std::make_unique<Propagation<TimingRecorder>>(mesh);
    case Record::wavefront:
      return std::make_unique<Propagation<WavefrontRecorder>>(mesh);
    case Record::windows:
      break;  // refused: this solver does not keep them
  }
  return nullptr;
}

}  // namespace
}  // namespace geodesic::edge_based::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace geodesic::edge_based {

std::unique_ptr<Propagator> make_recorded(const Mesh& mesh, InstructionSet set, Record what) {
#if GEODESIC_AVX2_BESIDE_STATIC
  if (set == InstructionSet::avx2) return N_AVX2::recorded(mesh, what);
#endif
  static_cast<void>(set);
  return HWY_STATIC_DISPATCH(recorded)(mesh, what);
}

}  // namespace geodesic::edge_based
#endif
