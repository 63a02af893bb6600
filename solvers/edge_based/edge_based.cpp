// Edge-based wavefront propagation: the algorithm of the thesis (chapter 5), whose published
// successor is Qin, Han, Yu, Yu, Zhang 2016, "Fast and memory-efficient Voronoi diagram
// construction and exact geodesics by vertex-oriented triangle propagation" (VTP).
//
// The wavefront is a set of half-edges that carry lists of windows. Vertices wait in a heap by
// distance. When one is popped, the faces around it are entered: every list on their edges is
// propagated across its face as a whole, trimmed by Strategy I (trim.h) and divided by Strategy II
// (split.h). Windows that land on an edge whose next face has been entered already go on at once,
// through a FIFO; all others wait. Any order is correct, since only beaten lines are ever dropped;
// this one keeps late arrivals rare.
//
// The loop (propagation-inl.h) and its steps over whole lists (kernels-inl.h) are compiled for
// several instruction sets; which one runs is chosen when a solver is constructed
// (core/instruction_set.h). All of them give the same bits.
// Two targets are enough: AVX2, and one window at a time for every other processor.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solvers/edge_based/edge_based.cpp"
#include <hwy/foreach_target.h>

#include "solvers/edge_based/propagation-inl.h"

#if HWY_ONCE
#include "solvers/registry.h"

namespace geodesic::edge_based {
namespace {

const Path& chosen_path() {
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
  if (geodesic::instruction_set() == InstructionSet::avx2) return N_AVX2::kPath;
#endif
  return HWY_STATIC_DISPATCH(kPath);
}

class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), path_(chosen_path()), timed_(path_.make_timed(mesh)) {}

  InstructionSet instruction_set() const override { return path_.instruction_set; }

 private:
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) {
      timed_->run(query, distances, nullptr);
    } else {
      path_.make_recorded(mesh(), recording->what)->run(query, distances, recording);
    }
  }

  const Path& path_;
  std::unique_ptr<Propagator> timed_;
};

const RegisterSolver<EdgeBased> registered{{
    .name = "edge-based",
    .family = "edge-based",
    .paper = "thesis chapter 5; Qin, Han, Yu, Yu, Zhang 2016",
    .data_structure = "list and priority queue",
    .time_complexity = "O(n log_b n + n log n)",
    .space_complexity = "O(n)",
    .propagation = "edge",
    .spatial_order = true,
    .relative_time = 1,
}};

}  // namespace
}  // namespace geodesic::edge_based
#endif
