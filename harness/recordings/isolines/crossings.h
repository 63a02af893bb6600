// Where the distance along an edge passes a level.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/window.h"

namespace geodesic::harness {

struct Crossing {
  double at;   ///< position from the origin of the edge's own half-edge
  bool falls;  ///< the distance is below the level beyond this point, and not before it
};

/// The distance along an edge as its final windows and its ends give it.
struct EdgeDistance {
  std::span<const Window> windows;  ///< as FinalWindows gives them
  double length;                    ///< of the edge
  double at_origin, at_head;        ///< distances of its ends
};

/// All crossings of a level, ascending. They alternate, and agree with the ends: an end is inside
/// the level when its distance is below it, not when it is equal. So the crossings of a face's
/// three edges, met one after the other, alternate too.
/// @param result overwritten
void find_crossings(const EdgeDistance& edge, double level, std::vector<Crossing>& result);

}  // namespace geodesic::harness
