// Recorded solves of `edge-based` and `edge-based-approximate`, compiled apart from timed ones
// (core/recorders.h).
#include "solvers/edge_based/approximate.h"
#include "solvers/edge_based/recorded.h"

namespace geodesic::edge_based {

template void EdgeBased<ByDistance>::solve_recorded(const Mesh&, InstructionSet, Carried,
                                                    const InternalQuery&, std::span<double>,
                                                    Recording&);

void Approximate::solve_recorded(const InternalQuery& query, std::span<double> distances,
                                 Recording& recording) const {
  solve_recording(mesh(), query, distances, recording,
                  [&](const auto& recorder) { make_wavefront(recorder).run(query, distances); });
}

}  // namespace geodesic::edge_based
