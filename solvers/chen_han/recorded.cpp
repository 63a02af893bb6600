// Apart from chen_han.cpp, so that what the compiler inlines into a timed solve does not depend on
// instrumentation.
#include "solvers/chen_han/recorded.h"

#include "solvers/chen_han/policies.h"
#include "solvers/chen_han/propagation.h"

namespace geodesic::chen_han {

template <class Policy>
void solve_recorded(const Mesh& mesh, const Query& query, std::span<double> distances,
                    Recording& recording) {
  solve_recording(recording, [&](auto recorder) {
    if constexpr (recorder.kRecords) recording.window_bytes = sizeof(StoredWindow<NoDepth>);
    Propagation<Policy, decltype(recorder)>(mesh, recorder).run(query, distances);
  });
}

template void solve_recorded<Ch>(const Mesh&, const Query&, std::span<double>, Recording&);
template void solve_recorded<Ich>(const Mesh&, const Query&, std::span<double>, Recording&);
template void solve_recorded<FwpCh>(const Mesh&, const Query&, std::span<double>, Recording&);

}  // namespace geodesic::chen_han
