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
#include "solvers/edge_based/propagation.h"
#include "solvers/registry.h"

namespace geodesic::edge_based {
namespace {

class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        instruction_set_(compiled_for(geodesic::instruction_set())),
        timed_(make_timed(mesh, instruction_set_)) {}

  InstructionSet instruction_set() const override { return instruction_set_; }

 private:
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) {
      timed_->run(query, distances, nullptr);
    } else {
      make_recorded(mesh(), instruction_set_, recording->what)->run(query, distances, recording);
    }
  }

  InstructionSet instruction_set_;
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
