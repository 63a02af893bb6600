// What the solvers of the family differ in. A policy has
//   Queue              of tickets, with the functions of PriorityQueue: the order of propagation
//   make_queue(mesh)   an empty one
//   Layout             which windows share a list (list_layout.h)
#pragma once

#include "solvers/core/queues/bucket_queue.h"
#include "solvers/core/queues/bucket_width.h"
#include "solvers/core/queues/priority_queue.h"
#include "solvers/mmp/list_layout.h"

namespace geodesic::mmp {

/// Least distance first.
struct ByDistance {
  using Queue = PriorityQueue<Index>;
  using Layout = ListPerEdge;
  static Queue make_queue(const Mesh& mesh) { return Queue(priority_buckets(mesh)); }
};

/// Buckets of the published width, in phases.
struct ByBucket {
  using Queue = BucketQueue<Index>;
  using Layout = ListPerEdge;
  static Queue make_queue(const Mesh& mesh) { return Queue(published_bucket_width(mesh)); }
};

}  // namespace geodesic::mmp
