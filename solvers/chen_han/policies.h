// What the solvers of the family differ in. A policy has
//   Filter             which windows are dropped (filter.h)
//   Queue              of indices (core/queues): in which order windows are propagated
//   make_queue(mesh)   an empty one
#pragma once

#include "solvers/chen_han/filter.h"
#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/bucket_width.h"
#include "solvers/core/queues/fifo_queue.h"
#include "solvers/core/queues/priority_queue.h"

namespace geodesic::chen_han {

struct Ch {
  using Filter = NoFilter;
  using Queue = FifoQueue<Index>;
  static Queue make_queue(const Mesh&) { return {}; }
};

struct Ich {
  using Filter = XinWangFilter;
  using Queue = PriorityQueue<Index>;
  static Queue make_queue(const Mesh& mesh) { return Queue(priority_buckets(mesh)); }
};

struct FwpCh {
  using Filter = XinWangFilter;
  using Queue = BucketQueue<Index>;
  /// Buckets of the published width.
  static Queue make_queue(const Mesh& mesh) { return Queue(published_bucket_width(mesh)); }
};

}  // namespace geodesic::chen_han
