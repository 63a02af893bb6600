// The solvers of the family CH: one propagation (propagation.h) with a policy for each.
//
// A policy has
//   Filter             which windows are dropped (filter.h)
//   Queue              of windows, in the order of propagation (WindowQueue)
//   make_queue(mesh)   an empty one; with (mesh, description), it reads parameters (queue_of.h)
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "solvers/chen_han/propagation.h"
#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/calendar_queue.h"
#include "solvers/core/queues/fifo_queue.h"
#include "solvers/core/queues/queue_of.h"
#include "solvers/core/registry.h"

namespace geodesic::chen_han {

struct Ch {
  using Filter = NoFilter;
  using Queue = FifoQueue<Index>;
  static Queue make_queue(const Mesh&) { return {}; }
};

struct Ich {
  using Filter = XinWangFilter;
  using Queue = CalendarQueue<Index>;
  static Queue make_queue(const Mesh& mesh) { return Queue(calendar_buckets(mesh)); }
};

struct FwpCh {
  using Filter = XinWangFilter;
  using Queue = BucketQueue<Index>;
  static Queue make_queue(const Mesh& mesh) { return Queue(published_bucket_width(mesh)); }
};

template <class Policy>
class ChenHan final : public Solver {
 public:
  ChenHan(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    if (mesh.has_thin_faces()) return;
    timed_.emplace(mesh, queue_of<Policy>(mesh, description));
  }

 private:
  /// A recorded solve; defined in recorded.h, like the next function.
  void solve_recorded(const Start& start, std::span<double> distances, Recording& recording) const;
  /// A timed solve with windows that store the length of their strip (core/window_bound.h).
  void solve_with_strip_lengths(const Start& start, std::span<double> distances);

  void run(const Start& start, std::span<double> distances) override {
    if (!timed_.has_value()) return solve_with_strip_lengths(start, distances);
    timed_->run(start, distances);
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    solve_recorded(start, distances, recording);
  }

  // On meshes with thin faces only the second one is used. It is made in recorded.h.
  std::optional<Propagation<Policy, DepthOf<Policy, NoRecorder>, NoRecorder>> timed_;
  std::unique_ptr<Propagation<Policy, StripDepth, NoRecorder>> timed_with_lengths_;
};

}  // namespace geodesic::chen_han
