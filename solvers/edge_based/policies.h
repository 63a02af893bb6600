// What the solvers of the family differ in. A policy has
//   Queue              of vertices that wait for the wavefront, with the functions of VertexHeap
//   make_queue(mesh)   an empty one
// Any order of vertices is correct; one by distance keeps late arrivals rare.
#pragma once

#include "solvers/core/mesh.h"
#include "solvers/core/queues/vertex_heap.h"

namespace geodesic::edge_based {

/// Least distance first.
struct ByDistance {
  using Queue = VertexHeap;
  static Queue make_queue(const Mesh& mesh) { return Queue(mesh.vertex_count()); }
};

}  // namespace geodesic::edge_based
