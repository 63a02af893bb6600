// `edge-based-bucket`: edge-based propagation with vertices in buckets in place of a heap.
#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/edge_based/recorded.h"

namespace geodesic::edge_based_bucket {

struct InBuckets {
  /// Of a bucket, in mean edge lengths.
  static constexpr double kWidth = 0.125;

  using Queue = VertexCalendar;
  static Queue make_queue(const Mesh& mesh) {
    return Queue(mesh.vertex_count(), kWidth * mesh.mean_edge_length());
  }
};

namespace {

const RegisterSolver<edge_based::EdgeBased<InBuckets>> registered{{
    .name = "edge-based-bucket",
    .family = "edge-based",
    .paper = "thesis chapter 5; buckets as in Xu, Wang, Liu, Liu, He 2015",
    .abilities = {.non_manifold_edges = true, .surface_sources = true, .paths = true},
}};

}  // namespace
}  // namespace geodesic::edge_based_bucket
