// One solve of the edge-based algorithm, as seen from outside the instruction sets, and the
// policies that its solvers differ in. A policy has
//   Queue              of vertices that wait for the wavefront (VertexQueue)
//   make_queue(mesh)   an empty one
//   Lists<note>        in which windows wait on half-edges, with the functions of WindowLists;
//                      where its kCarries is true, also with carry, land_carried and
//                      for_each_carried (propagation-inl.h), for windows that cross a face without
//                      being unfolded
// Any order of vertices is correct; one by distance keeps late arrivals rare.
#pragma once

#include <span>

#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/solver.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// Least distance first.
struct ByDistance {
  using Queue = VertexHeap;
  template <Note note>
  using Lists = WindowLists<note>;
  static Queue make_queue(const Mesh& mesh) { return Queue(mesh.vertex_count()); }
};

/// A source in a face is near a corner when it is closer than this times the face's longest side.
/// Coordinates of a source r from the corner, in a face of extent 1, turn its lines by 1e-16 / r.
/// At a distance D that is a gap of up to 1e-14 D, less than the kApexTolerance by which lines may
/// miss an apex as long as D is below 10^4.
inline constexpr double kNearCorner = 1e-2;

/// @tparam Recorder core/recorders.h
template <class Recorder>
class Propagator {
 public:
  virtual ~Propagator() = default;
  /// As Solver::run.
  virtual void run(const Query& query, std::span<double> distances, Recorder recorder) = 0;
};

}  // namespace geodesic::edge_based
