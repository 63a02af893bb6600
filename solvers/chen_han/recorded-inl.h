// For the file recorded.cpp of a solver's folder and no other, so that what the compiler inlines
// into a timed solve does not depend on instrumentation. That file instantiates Recorded for the
// folder's policies.
#pragma once

#include "solvers/chen_han/propagation.h"
#include "solvers/chen_han/recorded.h"

namespace geodesic::chen_han {

template <class Policy>
void Recorded<Policy>::solve(const Mesh& mesh, const Query& query, std::span<double> distances,
                             Recording& recording) {
  solve_recording(recording, [&](auto recorder) {
    if constexpr (recorder.kRecords) recording.window_bytes = sizeof(StoredWindow<NoDepth>);
    Propagation<Policy, decltype(recorder)>(mesh, recorder).run(query, distances);
  });
}

}  // namespace geodesic::chen_han
