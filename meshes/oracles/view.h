// Finds the vertices that are visible from a vertex along straight lines on the surface. The strip
// of faces is unfolded into a plane in which the first vertex lies at (0, 0).
#pragma once

#include <functional>
#include <span>

#include "meshes/plane.h"
#include "solvers/core/mesh.h"

namespace geodesic {

/// An unfolded edge that a line crosses. The face beyond the edge is that of the half-edge.
struct EdgeInView {
  Index half_edge;
  PlanePoint origin, head;
};

/// A vertex that is visible across the edges of a strip, nearest first.
struct Sight {
  Index vertex;
  PlanePoint at;
  Real length;
  /// Valid during the call of `see`; empty if the line runs along edges, as in a face without area.
  std::span<const EdgeInView> strip;
};

/// Returns the distance of two vertices in space.
Real straight_distance(const Mesh& mesh, Index a, Index b);

/// Returns the apex of the face of half-edge h when h is placed from p to q, which must differ,
/// with the face on its left.
PlanePoint lay_out_apex(const Mesh& mesh, Index h, const PlanePoint& p, const PlanePoint& q);

/// Unfolds every strip of faces that is visible from vertex v, while it is nearer than `reach` and
/// enters no face twice, which a shortest path never does. Nothing else is pruned. The function
/// ends however degenerate the faces are. Lengths come from the positions, only the topology
/// (twins) from the mesh. A line through a vertex ends there, and neighbours along edges are not
/// visible across a strip: `see` is called for neither.
void view_from(const Mesh& mesh, Index v, Real reach, const std::function<void(const Sight&)>& see);

}  // namespace geodesic
