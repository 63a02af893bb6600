// `edge-based-lazy`: windows that cover no vertex cross faces in one operation (thesis 6.2.1).
#include "solvers/edge_based/edge_based.h"

#include "solvers/variants/edge_based_lazy/chunk_lists.h"

namespace geodesic::edge_based_lazy {

/// Lists that carry chunks of windows across faces.
struct Lazy : edge_based::ByDistance {
  template <edge_based::Note note>
  using Lists = ChunkLists<note>;
};

namespace {

const RegisterSolver<edge_based::EdgeBased<Lazy>> registered{{
    .name = "edge-based-lazy",
    .family = "edge-based",
    .paper = "thesis section 6.2.1",
    .data_structure = "list and priority queue",
    .time_complexity = "O(n log_b n + n log n)",
    .space_complexity = "O(n)",
    .propagation = "chunk of windows",
    .spatial_order = true,
    .abilities = {.surface_sources = true, .paths = true},
    .remarks = "chunks of windows that pass an apex on one side cross its face unseen",
}};

}  // namespace
}  // namespace geodesic::edge_based_lazy
