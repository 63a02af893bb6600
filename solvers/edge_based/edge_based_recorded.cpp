// Recorded solves of `edge-based` and `edge-based-approximate`, compiled apart from timed ones
// (core/recorders.h).
#include "solvers/edge_based/approximate.h"
#include "solvers/edge_based/recorded.h"

namespace geodesic::edge_based {

template void EdgeBased<ByDistance>::solve_recorded(Carried, const Start&, std::span<double>,
                                                    Recording&) const;

void Approximate::record(const Start& start, std::span<double> distances, Recording& recording) {
  if (exact_ != nullptr) return exact_->record(start, distances, recording);
  solve_recording(mesh(), start.query, distances, recording,
                  [&](const auto& recorder) { make_wavefront(recorder).run(start, distances); });
}

}  // namespace geodesic::edge_based
