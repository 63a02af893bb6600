// Recorded solves of the family MMP, for the files that instantiate them (core/recorders.h).
#pragma once

#include "solvers/mmp/mmp.h"

namespace geodesic::mmp {

template <class Policy>
void Mmp<Policy>::solve_recorded(const Start& start, std::span<double> distances,
                                 Recording& recording) const {
  solve_recording(mesh(), start.query, distances, recording, [&](auto recorder) {
    recorder.reinserted(0);
    recorder.window_bytes(sizeof(EdgeWindow<WindowOrigin<NoRecorder>>) + sizeof(ListedWindow));
    Propagation<Policy, decltype(recorder)>(mesh(), queue_of<Policy>(mesh(), description()),
                                            recorder)
        .run(start, distances);
  });
}

}  // namespace geodesic::mmp
