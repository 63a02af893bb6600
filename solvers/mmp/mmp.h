// The solvers of the family MMP: one propagation (propagation.h) with a policy for each.
//
// A policy has
//   Queue              of windows, in the order of propagation (WindowQueueByKey)
//   make_queue(mesh)   an empty one; with (mesh, description), it reads parameters (queue_of.h)
#pragma once

#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/calendar_queue.h"
#include "solvers/core/queues/queue_of.h"
#include "solvers/core/registry.h"
#include "solvers/mmp/propagation.h"

namespace geodesic::mmp {

/// Least distance first.
struct ByDistance {
  using Queue = CalendarQueue<Index>;
  static Queue make_queue(const Mesh& mesh) { return Queue(calendar_buckets(mesh)); }
};

/// Buckets of the published width, in phases.
struct ByBucket {
  using Queue = BucketQueue<Index>;
  static Queue make_queue(const Mesh& mesh) { return Queue(published_bucket_width(mesh)); }
};

template <class Policy>
class Mmp final : public Solver {
 public:
  Mmp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(mesh, queue_of<Policy>(mesh, description)) {}

 private:
  /// A recorded solve; defined in recorded.h.
  void solve_recorded(const Start& start, std::span<double> distances, Recording& recording) const;

  void run(const Start& start, std::span<double> distances) override {
    propagation_.run(start, distances);
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    if (recording.kind != RecordingKind::windows) {
      return solve_recorded(start, distances, recording);
    }
    propagation_.run(start, distances, Keep::for_readers);
    hand_over_windows(*recording.read_windows);
  }

  void hand_over_windows(const ReadWindows& read) const {
    read([this](Index h, std::vector<Window>& windows) { propagation_.copy_windows(h, windows); });
  }

  Propagation<Policy, NoRecorder> propagation_;
};

}  // namespace geodesic::mmp
