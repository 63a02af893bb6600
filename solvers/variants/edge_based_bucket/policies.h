// Vertices in buckets: a vertex need not be the very nearest one to be next, since any order is
// correct; a heap pays for an order that nothing needs.
#pragma once

#include "solvers/core/queues/vertex_buckets.h"
#include "solvers/edge_based/policies.h"

namespace geodesic::edge_based_bucket {

struct InBuckets : edge_based::ByDistance {
  /// Of a bucket, in mean edge lengths.
  static constexpr double kWidth = 0.125;

  using Queue = VertexBuckets;
  static Queue make_queue(const Mesh& mesh) {
    return Queue(mesh.vertex_count(), kWidth * mesh.mean_edge_length());
  }
};

}  // namespace geodesic::edge_based_bucket
