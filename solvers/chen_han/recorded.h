// Recorded solves of the family CH, for the files that instantiate them (core/recorders.h).
#pragma once

#include "solvers/chen_han/chen_han.h"

namespace geodesic::chen_han {

template <class Depth, class Policy, class Recorder>
void solve_once(const Solver& solver, const Start& start, std::span<double> distances,
                const Recorder& recorder) {
  const Mesh& mesh = solver.mesh();
  Propagation<Policy, Depth, Recorder>(mesh, queue_of<Policy>(mesh, solver.description()), recorder)
      .run(start, distances);
}

template <class Policy>
void ChenHan<Policy>::solve_recorded(const Start& start, std::span<double> distances,
                                     Recording& recording) const {
  solve_recording(mesh(), start.query, distances, recording, [&](auto recorder) {
    using Recorder = decltype(recorder);
    recorder.window_bytes(sizeof(StoredWindow<NoDepth>));
    if (mesh().has_thin_faces()) {
      solve_once<StripDepth, Policy>(*this, start, distances, recorder);
    } else {
      solve_once<DepthOf<Policy, Recorder>, Policy>(*this, start, distances, recorder);
    }
  });
}

template <class Policy>
void ChenHan<Policy>::solve_with_strip_lengths(const Start& start,
                                               std::span<double> distances) const {
  solve_once<StripDepth, Policy>(*this, start, distances, NoRecorder());
}

}  // namespace geodesic::chen_han
