// Recorded solves of the family CH, for the files that instantiate them (core/recorders.h).
#pragma once

#include "solvers/chen_han/chen_han.h"

namespace geodesic::chen_han {

template <class Policy>
void ChenHan<Policy>::solve_recorded(const Start& start, std::span<double> distances,
                                     Recording& recording) const {
  solve_recording(mesh(), start.query, distances, recording, [&](auto recorder) {
    using Recorder = decltype(recorder);
    recorder.window_bytes(sizeof(StoredWindow<NoDepth>));
    Propagation<Policy, DepthOf<Policy, Recorder>, Recorder>(
        mesh(), queue_of<Policy>(mesh(), description()), recorder)
        .run(start, distances);
  });
}

template <class Policy>
void ChenHan<Policy>::solve_dropping_long_strips(const Start& start,
                                                 std::span<double> distances) const {
  Propagation<Policy, StripDepth, NoRecorder>(mesh(), queue_of<Policy>(mesh(), description()))
      .run(start, distances);
}

}  // namespace geodesic::chen_han
