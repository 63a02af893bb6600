// Apart from mmp.cpp, so that what the compiler inlines into a timed solve does not depend on
// instrumentation: a timed solve takes 1% more instructions in one file with it.
#include "solvers/mmp/recorded.h"

#include "solvers/mmp/orders.h"
#include "solvers/mmp/propagation.h"

namespace geodesic::mmp {

template <class Order>
void solve_recorded(const Mesh& mesh, const Query& query, std::span<double> distances,
                    Recording& recording) {
  solve_recording(recording, [&](auto recorder) {
    if constexpr (recorder.kRecords) {
      recording.reinsertions = 0;
      recording.window_bytes = sizeof(EdgeWindow<NoDepth>);
    }
    Propagation<typename Order::Queue, decltype(recorder)>(mesh, Order::make(mesh), recorder)
        .run(query, distances);
  });
}

template void solve_recorded<ByDistance>(const Mesh&, const Query&, std::span<double>, Recording&);
template void solve_recorded<ByBucket>(const Mesh&, const Query&, std::span<double>, Recording&);

}  // namespace geodesic::mmp
