// Which windows share a list, and with it are trimmed against each other.
//
// A list goes by a half-edge, in whose frame its windows are (edge_window.h).
#pragma once

#include <algorithm>

#include "solvers/core/geometry.h"

namespace geodesic::mmp {

/// One list an edge (Liu 2013), named by its own half-edge, the smaller of the twins.
struct ListPerEdge {
  /// Windows of both sides are in it.
  static constexpr bool kBothSides = true;

  /// The list of windows that leave a face through `half_edge`.
  /// @param twin kNone, which is larger than any half-edge, on the boundary
  static Index list(Index half_edge, Index twin) { return std::min(half_edge, twin); }
};

/// Two lists an edge, one for each side that windows come from (Surazhsky et al. 2005).
struct ListPerHalfEdge {
  static constexpr bool kBothSides = false;
  static Index list(Index half_edge, Index /*twin*/) { return half_edge; }
};

}  // namespace geodesic::mmp
