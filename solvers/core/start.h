// Where the propagation of a query begins: its sources as vertices and windows.
#pragma once

#include <vector>

#include "solvers/core/query.h"
#include "solvers/core/recording.h"
#include "solvers/core/window.h"

namespace geodesic {

/// A vertex that has a distance from the first on.
struct StartVertex {
  Index vertex;
  double distance;
  /// Whether the vertex sends windows in all directions, as a source does, even if it is no
  /// pseudo-source: a source, or a corner right next to one.
  bool always_emits;
  LastSegment last_segment;  ///< of the path from the source
};

/// Lines from a source inside a face, through the whole of a side of the face.
struct StartWindow {
  Index side;     ///< half-edge of the source's face; its twin may not exist
  Window window;  ///< in the frame of the twin
  Index root;     ///< as in LastSegment
};

/// A query in the form in which window propagation begins.
///
/// A source at a vertex is that vertex. From a source inside a face or on an edge, straight lines
/// lead to the corners of its face, or faces, and through the sides on which it does not lie. Next
/// to a corner, rounding of coordinates turns the lines on both sides of it, and may leave a gap
/// behind it: the corner then always emits. Its windows are as long or longer, and soon beaten. If
/// the source is so near to a corner that rounding exceeds the way there and back, its own lines
/// have no direction, and only the corners emit.
struct Start {
  Start(const Mesh& mesh, InternalQuery lowered);

  InternalQuery query;                ///< the sources as points, the limit and the targets
  std::vector<StartVertex> vertices;  ///< a vertex may occur several times
  std::vector<StartWindow> windows;   ///< by source
};

}  // namespace geodesic
