// Splits obtuse corners by vertices beyond the opposite edge.
//
// A planar wave may enter an obtuse corner before it has passed both of the corner's neighbours.
// Kimmel and Sethian 1998, section 4.2, unfold the faces beyond the opposite edge into the corner's
// plane until a vertex lies in the section: the directions at acute or right angles to both sides
// of the corner. That vertex splits the corner into two that are not obtuse.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solvers/core/window.h"

namespace geodesic::fast_marching {

/// A vertex that splits an obtuse corner.
struct Splitter {
  Index vertex;
  Index opposite;  ///< the half-edge whose apex is the corner
  Point2 at;       ///< unfolded, in the frame of that half-edge
};

/// Finds the first vertex in the section of the corner at the apex of h.
/// @return nothing if the corner is not obtuse, or if the section meets a boundary, a collapsed
///         edge, or no vertex within kMostUnfolded faces
std::optional<Splitter> split_corner(const Mesh& mesh, Index h);

/// Largest number of unfolded faces; sufficient for meshes whose angles are not minute.
inline constexpr int kMostUnfolded = 64;

/// All splitters of a mesh, by corner and by vertex.
class Splitters {
 public:
  explicit Splitters(const Mesh& mesh);

  /// @return null if the corner at the apex of h has none
  const Splitter* of_corner(Index h) const {
    return of_corner_[h] == kNone ? nullptr : &splitters_[of_corner_[h]];
  }
  /// The splitters of the corners that v splits.
  std::span<const Splitter> by_vertex(Index v) const {
    return std::span(splitters_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

 private:
  std::vector<Splitter> splitters_;  // in the order of their vertices
  std::vector<Index> first_;         // per vertex and one more, into splitters_
  std::vector<Index> of_corner_;     // per half-edge, into splitters_
};

}  // namespace geodesic::fast_marching
