// For the file recorded.cpp of a solver's folder and no other, so that what the compiler inlines
// into a timed solve does not depend on instrumentation: a timed solve takes 1% more instructions
// in one file with it. That file instantiates Recorded for the folder's policies.
#pragma once

#include "solvers/mmp/propagation.h"
#include "solvers/mmp/recorded.h"

namespace geodesic::mmp {

template <class Policy>
void Recorded<Policy>::solve(const Mesh& mesh, const Query& query, std::span<double> distances,
                             Recording& recording) {
  solve_recording(recording, [&](auto recorder) {
    if constexpr (recorder.kRecords) {
      recording.reinsertions = 0;
      recording.window_bytes = sizeof(EdgeWindow<NoDepth>);
    }
    Propagation<Policy, decltype(recorder)>(mesh, recorder).run(query, distances);
  });
}

}  // namespace geodesic::mmp
