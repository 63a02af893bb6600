// Making neighbouring faces run the same way round.
#pragma once

#include <span>
#include <vector>

#include "meshes/edges.h"

namespace geodesic {

/// What it takes to orient the faces that are connected across edges of exactly two faces.
struct Orientation {
  std::vector<bool> flipped;  ///< one a triangle: it must run the other way round
  std::size_t flips = 0;
  /// Edges whose two faces run against one another whatever is flipped: the surface has one side
  /// only, like a Moebius strip. 0 when it is orientable.
  std::size_t one_sided_edges = 0;
};

/// Walks over each connected part breadth-first from its triangle of least index, which keeps its
/// direction; sides are taken in the order of their half-edges, so the outcome is determined.
Orientation orient(std::span<const Triangle> triangles, const EdgeTable& edges);

/// The triangle the other way round, from the same first vertex.
inline Triangle flip(const Triangle& t) { return {t[0], t[2], t[1]}; }

}  // namespace geodesic
