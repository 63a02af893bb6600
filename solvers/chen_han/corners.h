// One angle, one split (Chen and Han 1990, section 3).
//
// The lines of several windows of an edge may reach the apex of the face beyond. The window that
// gives the apex its least distance so far owns the corner; only it has children on both other
// edges. Any other has its child on the side from which its line to the apex comes. On the far side
// its lines have crossed the owner's line to the apex, where the owner is at least as near.
#pragma once

#include <cmath>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/prefetch.h"
#include "solvers/core/window_predicates.h"

namespace geodesic::chen_han {

class Corners {
 public:
  /// @param corners number of half-edges; each names the corner opposite to it in its face
  explicit Corners(Index corners) : owners_(corners) {}

  void clear() { owners_.assign(owners_.size(), {}); }

  /// Returns the sides of the apex on which a window of half-edge h has children. Its line to the
  /// apex has length `distance` and crosses the edge at `position`. Makes the window the owner of
  /// the corner if it is the nearest so far.
  ///
  /// Lines that cross the edge less than `resolution` apart have no side: coincident vertices send
  /// out windows from one point that see different parts of the edge. Lines of such a window that
  /// cross the edge near the owner's line are beaten by the owner's path to its own crossing and
  /// from there along the edge. The window has a child on each side on which it has farther lines.
  /// Without this rule nothing bounds the number of narrow windows that wind round a tube.
  Sides claim(Index h, const Window& w, double distance, double position, double resolution) {
    Owner& owner = owners_[h];
    if (distance < owner.distance) {
      owner = {distance, position};
      return {true, true};
    }
    if (std::abs(position - owner.position) > resolution) {
      return sides_not_crossing({true, true}, position, position, owner.position);
    }
    const double beaten = (distance - owner.distance) / 2 - resolution;  // from `position` on
    return {position - w.begin > beaten, w.end - position > beaten};
  }

  /// Starts to load the owner of a corner.
  void prefetch(Index h) const { geodesic::prefetch(&owners_[h]); }

 private:
  struct Owner {
    double distance = kInfinity;
    double position = 0;
  };
  std::vector<Owner> owners_;
};

}  // namespace geodesic::chen_han
