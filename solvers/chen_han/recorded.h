// Recorded solves of the family CH, for the files that instantiate them (core/recorders.h).
#pragma once

#include "solvers/chen_han/chen_han.h"

namespace geodesic::chen_han {

template <class Policy>
void ChenHan<Policy>::solve_recorded(const Mesh& mesh, const InternalQuery& query,
                                     std::span<double> distances, Recording& recording) {
  solve_recording(mesh, query, distances, recording, [&](auto recorder) {
    using Recorder = decltype(recorder);
    recorder.window_bytes(sizeof(StoredWindow<NoDepth>));
    Propagation<Policy, DepthOf<Policy, Recorder>, Recorder>(mesh, recorder).run(query, distances);
  });
}

template <class Policy>
void ChenHan<Policy>::solve_dropping_long_strips(const Mesh& mesh, const InternalQuery& query,
                                                 std::span<double> distances) {
  Propagation<Policy, StripDepth, NoRecorder>(mesh).run(query, distances);
}

}  // namespace geodesic::chen_han
