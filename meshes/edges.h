// The edges of a triangle soup: which faces share each of them, however many they are and whichever
// way they run. Half-edge 3 f + k is the k-th side of triangle f, as in solvers/core/mesh.h.
#pragma once

#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A side of a face, seen from its undirected edge.
struct EdgeSide {
  Index low;   ///< the end of smaller index
  Index high;  ///< the other end
  Index half_edge;
};

/// The two corners of a half-edge's face that lie at its ends, as half-edges that start there.
inline Index next_in_face(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index previous_in_face(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

inline Index origin_of(std::span<const Triangle> triangles, Index h) {
  return triangles[h / 3][h % 3];
}

class EdgeTable {
 public:
  /// @param usable one flag a triangle; the others are left out. Usable triangles name three
  ///        different vertices below vertex_count.
  EdgeTable(std::span<const Triangle> triangles, const std::vector<bool>& usable,
            std::size_t vertex_count);

  /// Calls visit(std::span<const EdgeSide>) for every edge with all its sides, in order of their
  /// half-edges; edges come in order of (low, high).
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t end = i + 1;
      while (end < sides_.size() && sides_[end].low == sides_[i].low &&
             sides_[end].high == sides_[i].high) {
        ++end;
      }
      visit(std::span<const EdgeSide>(sides_).subspan(i, end - i));
      i = end;
    }
  }

 private:
  std::vector<EdgeSide> sides_;
};

}  // namespace geodesic
