// Where the lines of a pseudo-source go.
//
// A shortest path through a vertex makes an angle of at least pi on each of its sides that lies on
// the surface (Mitchell, Mount, Papadimitriou 1987, section 3). A pseudo-source therefore sends
// windows only into the shadow of the line along which its own distance arrived; everything else is
// lit by windows that passed the vertex. At a saddle the shadow is a wedge as wide as the angle's
// excess over 2 pi; at a boundary vertex it is what lies more than pi away on either side. It is
// taken wider by kShadowMargin: among paths that are equally long but for rounding it is chance
// which one gives the distance, and the lines of the others pass the vertex elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::chen_han {

/// The direction from a vertex back along the path that gave it its distance.
struct Incoming {
  Index corner = kNone;  ///< half-edge that leaves the vertex in the face of the path's last piece;
                         ///< kNone when there is no path (a source): the shadow is everywhere
  double x = 0, y = 0;   ///< the direction in that half-edge's frame, of any length
};

/// The part in the shadow of an edge opposite to the vertex.
struct ShadowedEdge {
  Index across;       ///< half-edge of the edge in the face that it shares with the vertex
  double begin, end;  ///< positions from the head of `across`
};

/// Fills `edges` with the edges opposite to v that lie wholly or partly in the shadow.
void find_shadow(const Mesh& mesh, Index v, const Incoming& incoming,
                 std::vector<ShadowedEdge>& edges);

/// Marks, one entry a vertex, the corners of faces without reliable angles (a zero-length edge, no
/// area up to rounding) and their neighbours. There, pseudo-sources coincide or lie in line: which
/// of them is nearer, and from where its path arrives, is chance, and a window may be dropped in
/// favour of one that was dropped in its favour. Marked vertices send windows into all their faces
/// and the corners of their faces have no owner; the filter alone stops windows there.
std::vector<std::uint8_t> find_unreliable_vertices(const Mesh& mesh);

}  // namespace geodesic::chen_han
