// One solve of the edge-based algorithm, as seen from outside the instruction sets, and the
// policies that its solvers differ in. A policy has
//   Queue              of vertices that wait for the wavefront (VertexQueue)
//   make_queue(mesh)   an empty one
//   kMerges            whether windows of an edge are merged (merge.h); if so, also
//   shortfall()        the greatest, relative to distances; 0: the solver is `edge-based`
//   share()            of a vertex's shortfall, which is added to its distance in the end
// and is made from the solver's description where it can be.
// Any order of vertices is correct; one by distance keeps late arrivals rare.
#pragma once

#include <span>

#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/solver.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// Least distance first.
struct ByDistance {
  static constexpr bool kMerges = false;

  using Queue = VertexHeap;
  static Queue make_queue(const Mesh& mesh) { return Queue(mesh.vertex_count()); }
};

/// @tparam Recorder core/recorders.h
template <class Recorder>
class Propagator {
 public:
  virtual ~Propagator() = default;
  /// As Solver::run.
  virtual void run(const Query& query, std::span<double> distances, Recorder recorder) = 0;
};

}  // namespace geodesic::edge_based
