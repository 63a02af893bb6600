// `edge-based-bucket`: edge-based propagation with vertices in buckets in place of a heap.
#include "solvers/core/registry.h"
#include "solvers/edge_based/solver.h"
#include "solvers/variants/edge_based_bucket/policies.h"

namespace geodesic::edge_based_bucket {
namespace {

const RegisterSolver<edge_based::EdgeBased<InBuckets>> registered{{
    .name = "edge-based-bucket",
    .family = "edge-based",
    .paper = "thesis chapter 5; buckets as in Xu, Wang, Liu, Liu, He 2015",
    .data_structure = "list and bucket queue",
    .time_complexity = "O(n log_b n)",
    .space_complexity = "O(n)",
    .propagation = "edge",
    .spatial_order = true,
    .by_name_only = true,
}};

}  // namespace
}  // namespace geodesic::edge_based_bucket
