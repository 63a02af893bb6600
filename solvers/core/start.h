// Where the propagation of a query begins: its sources as vertices and windows.
#pragma once

#include <unordered_map>
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

/// True when lines through a face are as short as those of a window up to rounding, on all of its
/// interval. With equal sigma, points that are as far from both lie on a line: the ends of the
/// interval decide.
///
/// No shortest path enters a face at its root again: within a face, the straight line is shorter.
/// Beside the tip of needles, lines wind around the tip as often as the needles are longer than
/// wide. Each turn is longer by less than rounding, which shortens some by more: no distance then
/// shows that they have come back.
/// @param lines in the frame of w
/// @param rounding of coordinates
[[gnu::cold]] bool lines_beat(const Window& lines, const Window& w, double rounding);

/// The lines that leave the faces of sources, by the sides that they cross.
class StartLines {
 public:
  bool empty() const { return by_side_.empty(); }
  void clear() { by_side_.clear(); }
  /// @param length of the side
  void add(const StartWindow& start, double length) {
    const auto& [begin, end, x, y, sigma] = start.window;
    by_side_.emplace(start.side, Window{length - end, length - begin, length - x, -y, sigma});
  }

  /// Whether lines from a source in the face of h beat a window.
  /// @param w in the frame of h, whose face it enters
  [[gnu::cold]] bool beat(const Window& w, Index h, double rounding) const;

 private:
  std::unordered_multimap<Index, Window> by_side_;  // in the frames of the sides
};

}  // namespace geodesic
