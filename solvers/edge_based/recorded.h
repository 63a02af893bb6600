// Recorded solves of EdgeBased, for the files that instantiate them (core/recorders.h).
#pragma once

#include "solvers/edge_based/edge_based.h"

namespace geodesic::edge_based {

template <class Policy>
void EdgeBased<Policy>::solve_recorded(Carried carried, const Start& start,
                                       std::span<double> distances, Recording& recording) const {
  solve_recording(mesh(), start.query, distances, recording, [&](const auto& recorder) {
    make_wavefront(carried, recorder).run(start, distances);
  });
}

}  // namespace geodesic::edge_based
