// Recorded solves of EdgeBased, for the files that instantiate them (core/recorders.h).
#pragma once

#include "solvers/edge_based/edge_based.h"

namespace geodesic::edge_based {

template <class Order>
void EdgeBased<Order>::solve_recorded(const Mesh& mesh, InstructionSet set, Carried carried,
                                      const InternalQuery& query, std::span<double> distances,
                                      Recording& recording) {
  solve_recording(mesh, query, distances, recording, [&](const auto& recorder) {
    make_wavefront(mesh, set, carried, recorder).run(query, distances);
  });
}

}  // namespace geodesic::edge_based
