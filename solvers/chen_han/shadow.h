// The directions in which a pseudo-source sends windows.
//
// A shortest path through a vertex makes an angle of at least pi on each of its sides that lies on
// the surface (Mitchell, Mount, Papadimitriou 1987, section 3). A pseudo-source therefore sends
// windows only into the shadow of the line along which its own distance arrived; windows that
// passed the vertex cover the rest. At a saddle the shadow is a wedge as wide as the angle's excess
// over 2 pi; at a boundary vertex it is the part more than pi away on either side. It is widened by
// kShadowMargin: among paths of equal length up to rounding it is chance which one gives the
// distance, and the lines of the others pass the vertex elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::chen_han {

/// The direction from a vertex back along the path that gave it its distance.
struct Incoming {
  Index corner = kNone;  ///< half-edge that leaves the vertex in the face of the path's last
                         ///< segment; kNone without a path (a source): the shadow is everywhere
  double x = 0, y = 0;   ///< the direction in that half-edge's frame, of any length
};

/// The shadowed part of an edge opposite the vertex.
struct ShadowedEdge {
  Index across;       ///< half-edge of the edge in the face of the vertex
  double begin, end;  ///< positions from the head of `across`
};

/// Fills `edges` with the edges opposite v that lie wholly or partly in the shadow.
void find_shadow(const Mesh& mesh, Index v, const Incoming& incoming,
                 std::vector<ShadowedEdge>& edges);

/// Marks (one entry per vertex) the corners of faces without reliable angles (a zero-length edge,
/// no area up to rounding) and their neighbours. There, pseudo-sources coincide or lie in line: it
/// is chance which of them is nearer and from where its path arrives, and of two windows each may
/// be dropped in favour of the other. Marked vertices send windows into all their faces, and the
/// corners of their faces have no owner; the filter alone stops windows there.
std::vector<std::uint8_t> find_unreliable_vertices(const Mesh& mesh);

}  // namespace geodesic::chen_han
