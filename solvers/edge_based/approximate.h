// Edge-based propagation that merges the windows of an edge as long as no distance is off by more
// than a tolerance. How, and why that holds: solvers/edge_based/merge.h.
#pragma once

#include <memory>

#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/registry.h"
#include "solvers/edge_based/edge_based.h"
#include "solvers/edge_based/merged_crossing.h"
#include "solvers/edge_based/wavefront.h"

namespace geodesic::edge_based {

/// Merges as long as a distance D is short of the truth by at most a shortfall s, and gives D +
/// kShare * s: off by no more than (1 - kShare) * s, which is what the tolerance limits.
class Approximate final : public Solver {
 public:
  Approximate(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    const double tolerance = description.real("tolerance");
    if (tolerance < kLeast) {
      exact_ = std::make_unique<EdgeBased<ByDistance>>(mesh, description);
    } else {
      shortfall_ = tolerance / (1 - kShare) * (1 - kRoundedUp);
      timed_ = std::make_unique<Merging<NoRecorder>>(make_wavefront(NoRecorder()));
    }
  }

  InstructionSet instruction_set() const override {
    return exact_ != nullptr ? exact_->instruction_set() : InstructionSet::plain;
  }

 private:
  template <class Recorder>
  using Merging = Wavefront<MergedCrossing, VertexHeap, Recorder>;

  /// Of the shortfall, of distances on scans: between 0.2 and 0.4, whatever the tolerance.
  static constexpr double kShare = 0.3;
  /// Vertices keep shortfalls in 32 bits, rounded up by less than this, relatively.
  static constexpr double kRoundedUp = 1e-6;
  /// What is less is not worth merging, and comes near to rounding.
  static constexpr double kLeast = 1e-9;

  template <class Recorder>
  Merging<Recorder> make_wavefront(const Recorder& recorder) const {
    return Merging<Recorder>(mesh(), VertexHeap(mesh().vertex_count()),
                             MergedCrossing(mesh(), shortfall_, kShare), recorder);
  }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (exact_ != nullptr) return exact_->run(query, distances, recording);
    if (recording == nullptr) return timed_->run(query, distances);
    record(query, distances, *recording);
  }

  /// A recorded solve, compiled apart (core/recorders.h).
  void record(const Query& query, std::span<double> distances, Recording& recording) const;

  std::unique_ptr<EdgeBased<ByDistance>> exact_;
  double shortfall_ = 0;  // the greatest, relative to distances
  std::unique_ptr<Merging<NoRecorder>> timed_;
};

}  // namespace geodesic::edge_based
