// `mmp` and `fwp-mmp`: the same propagation of windows in two orders.
#include "solvers/mmp/orders.h"
#include "solvers/mmp/propagation.h"
#include "solvers/mmp/recorded.h"
#include "solvers/registry.h"

namespace geodesic::mmp {
namespace {

template <class Order>
class Mmp final : public Solver {
 public:
  Mmp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(mesh, Order::make(mesh)) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return propagation_.run(query, distances);
    solve_recorded<Order>(mesh(), query, distances, *recording);
  }

  Propagation<typename Order::Queue, NoRecorder> propagation_;
};

const RegisterSolver<Mmp<ByDistance>> mmp{{
    .name = "mmp",
    .family = "MMP",
    .paper = "Mitchell, Mount, Papadimitriou 1987; Surazhsky et al. 2005; Liu 2013",
    .data_structure = "priority queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .relative_time = 12,
}};

const RegisterSolver<Mmp<ByBucket>> fwp_mmp{{
    .name = "fwp-mmp",
    .family = "MMP",
    .paper = "Xu, Wang, Liu, Liu, He 2015, Fast wavefront propagation; Liu 2013",
    .data_structure = "bucket and FIFO queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .relative_time = 10,
}};

}  // namespace
}  // namespace geodesic::mmp
