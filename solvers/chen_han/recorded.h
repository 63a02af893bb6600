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
    const auto solve_with = [&]<class Depth>(Depth) {
      Propagation<Policy, Depth, Recorder>(mesh(), queue_of<Policy>(mesh(), description()),
                                           recorder)
          .run(start, distances);
    };
    if (mesh().has_thin_faces()) {
      solve_with(StripDepth());
    } else {
      solve_with(DepthOf<Policy, Recorder>());
    }
  });
}

template <class Policy>
void ChenHan<Policy>::solve_with_strip_lengths(const Start& start, std::span<double> distances) {
  if (timed_with_lengths_ == nullptr) {
    timed_with_lengths_ = std::make_unique<Propagation<Policy, StripDepth, NoRecorder>>(
        mesh(), queue_of<Policy>(mesh(), description()));
  }
  timed_with_lengths_->run(start, distances);
}

}  // namespace geodesic::chen_han
