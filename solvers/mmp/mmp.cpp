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
    if (recording != nullptr && recording->what != Record::windows) {
      return solve_recorded<Order>(mesh(), query, distances, *recording);
    }
    propagation_.run(query, distances);
    if (recording != nullptr) hand_over_windows(*recording->read_windows);
  }

  void hand_over_windows(const ReadWindows& read) const {
    read([this](Index h, std::vector<Window>& windows) { propagation_.copy_windows(h, windows); });
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
    .final_windows = true,
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
    .final_windows = true,
    .relative_time = 10,
}};

}  // namespace
}  // namespace geodesic::mmp
