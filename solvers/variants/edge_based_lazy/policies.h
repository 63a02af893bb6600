// Edge-based propagation with lists that carry chunks of windows across faces.
#pragma once

#include "solvers/edge_based/policies.h"
#include "solvers/variants/edge_based_lazy/chunk_lists.h"

namespace geodesic::edge_based_lazy {

struct Lazy : edge_based::ByDistance {
  template <unsigned fields>
  using Lists = ChunkLists<fields>;
};

}  // namespace geodesic::edge_based_lazy
