// Edge-based propagation that merges windows of an edge while no distance has an error above a
// tolerance. Method and proof: solvers/edge_based/merge.h.
#pragma once

#include <memory>
#include <utility>

#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/core/registry.h"
#include "solvers/edge_based/edge_based.h"
#include "solvers/edge_based/merged_crossing.h"
#include "solvers/edge_based/wavefront.h"

namespace geodesic::edge_based {

/// Vertices wait in buckets, since the order within a bucket hardly matters.
class Approximate final : public Solver {
 public:
  Approximate(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), tolerance_(description.real("tolerance")) {
    if (tolerance_ < kLeastMerging) {
      exact_ = std::make_unique<EdgeBased<ByDistance>>(mesh, description);
    } else {
      timed_ = std::make_unique<Merging<NoRecorder>>(make_wavefront(NoRecorder()));
    }
  }

  InstructionSet instruction_set() const override {
    return exact_ != nullptr ? exact_->instruction_set() : InstructionSet::plain;
  }

 private:
  template <class Recorder>
  using Merging = Wavefront<MergedCrossing, VertexCalendar, Recorder>;

  /// Width of a bucket, in mean edge lengths.
  static constexpr double kBucketWidth = 1.0 / 16;

  template <class Recorder>
  Merging<Recorder> make_wavefront(const Recorder& recorder) const {
    VertexCalendar queue(mesh().vertex_count(), kBucketWidth * mesh().mean_edge_length());
    return Merging<Recorder>(mesh(), std::move(queue), MergedCrossing(mesh(), tolerance_),
                             recorder);
  }

  void run(const Start& start, std::span<double> distances) override {
    if (exact_ != nullptr) return exact_->run(start, distances);
    timed_->run(start, distances);
  }

  /// Compiled apart from timed solves (core/recorders.h).
  void record(const Start& start, std::span<double> distances, Recording& recording) override;

  double tolerance_;
  std::unique_ptr<EdgeBased<ByDistance>> exact_;
  std::unique_ptr<Merging<NoRecorder>> timed_;
};

}  // namespace geodesic::edge_based
