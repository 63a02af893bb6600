// The family CH as solvers: one propagation (propagation.h), with policies for what they differ in.
//
// A policy has
//   Filter             which windows are dropped (filter.h)
//   Queue              of windows, in the order of propagation (WindowQueue)
//   make_queue(mesh)   an empty one
#pragma once

#include <stdexcept>
#include <string>

#include "solvers/chen_han/propagation.h"
#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/calendar_queue.h"
#include "solvers/core/queues/fifo_queue.h"
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
  ChenHan(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(checked(mesh, description)) {}

  /// A recorded solve, compiled apart (core/recorders.h).
  static void record(const Mesh& mesh, const Query& query, std::span<double> distances,
                     Recording& recording);

 private:
  static const Mesh& checked(const Mesh& mesh, const Description& description) {
    if (mesh.vertex_count() <= kMaxRoots) return mesh;
    throw std::invalid_argument(description.name + ": supports at most " +
                                std::to_string(kMaxRoots) + " vertices");
  }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return propagation_.run(query, distances);
    record(mesh(), query, distances, *recording);
  }

  Propagation<Policy, NoRecorder> propagation_;
};

#ifdef GEODESIC_RECORDED
template <class Policy>
[[gnu::used]] void ChenHan<Policy>::record(const Mesh& mesh, const Query& query,
                                           std::span<double> distances, Recording& recording) {
  solve_recording(mesh, query, distances, recording, [&](auto recorder) {
    if constexpr (recorder.kRecords) recording.window_bytes = sizeof(StoredWindow<NoDepth>);
    Propagation<Policy, decltype(recorder)>(mesh, recorder).run(query, distances);
  });
}
#endif

}  // namespace geodesic::chen_han
