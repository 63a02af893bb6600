// `mmp` and `fwp-mmp`: the same propagation of windows in two orders.
#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/bucket_width.h"
#include "solvers/core/queues/priority_queue.h"
#include "solvers/mmp/propagation.h"
#include "solvers/registry.h"

namespace geodesic::mmp {
namespace {

/// Least distance first.
struct ByDistance {
  using Queue = PriorityQueue<Index>;
  static Queue make(const Mesh& mesh) { return Queue(priority_bucket_width(mesh)); }
};

/// Buckets of the published width, in phases.
struct ByBucket {
  using Queue = BucketQueue<Index>;
  static Queue make(const Mesh& mesh) { return Queue(published_bucket_width(mesh)); }
};

template <class Order>
class Mmp final : public Solver {
 public:
  Mmp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(mesh, Order::make(mesh)) {}

 private:
  template <class Recorder>
  using PropagationWith = Propagation<typename Order::Queue, Recorder>;

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return propagation_.run(query, distances, NoRecorder{});
    solve_recording(*recording, [&](auto recorder) {
      if constexpr (recorder.kRecords) {
        recording->reinsertions = 0;
        recording->window_bytes = sizeof(EdgeWindow<NoDepth>);
      }
      PropagationWith<decltype(recorder)>(mesh(), Order::make(mesh()))
          .run(query, distances, recorder);
    });
  }

  PropagationWith<NoRecorder> propagation_;
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
