// What a vertex sees along straight lines on the surface. The strip of faces is unfolded into a
// plane in which the vertex that looks lies at (0, 0).
#pragma once

#include <functional>
#include <span>

#include "meshes/plane.h"
#include "solvers/core/mesh.h"

namespace geodesic {

/// An edge that a line crosses, unfolded. The half-edge is the one whose face lies beyond.
struct EdgeInView {
  Index half_edge;
  PlanePoint origin, head;
};

/// A vertex that is seen across the edges of a strip, nearest first.
struct Sight {
  Index vertex;
  PlanePoint at;
  Real length;
  /// Valid during the call of `see`; empty when the line runs along edges, as it does
  /// in a face without area.
  std::span<const EdgeInView> strip;
};

/// Distance of two vertices in space.
Real straight_distance(const Mesh& mesh, Index a, Index b);

/// The apex of half-edge h's face when h is laid from p to q, which differ, with the face on its
/// left.
PlanePoint lay_out_apex(const Mesh& mesh, Index h, const PlanePoint& p, const PlanePoint& q);

/// Unfolds every strip of faces that can be seen from vertex v, as long as it lies nearer than
/// `reach` and enters no face twice, which a shortest path never does; nothing else is pruned.
/// However degenerate the faces are, it ends. Lengths are taken from the positions; only the
/// topology (twins) is the mesh's. A line that runs through a vertex ends there, and neighbours
/// along edges are not seen across a strip: `see` gets neither.
void view_from(const Mesh& mesh, Index v, Real reach, const std::function<void(const Sight&)>& see);

}  // namespace geodesic
