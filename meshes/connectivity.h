// Connectivity of the faces of a triangle soup: edges with all their faces, neighbours, fans,
// groups and orientation. The topology may be arbitrary.
//
// Half-edge 3 f + k is the k-th side of triangle f, as in solvers/core/mesh.h. A corner of a face
// has the number of the half-edge that starts there.
#pragma once

#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic {

/// Sets that are joined two at a time (Galler and Fischer 1964), with path halving.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t elements) : parent_(elements) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The least element of the set.
  Index find(Index element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  /// @return whether the two were in different sets
  bool join(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    return a != b;
  }

 private:
  std::vector<Index> parent_;
};

inline bool names_a_vertex_twice(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

inline Index next_in_face(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index previous_in_face(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
inline Index origin_of(std::span<const Triangle> triangles, Index h) {
  return triangles[h / 3][h % 3];
}

/// A side of a face, seen from its undirected edge.
struct EdgeSide {
  Index low;   ///< the end of smaller index
  Index high;  ///< the other end
  Index half_edge;
};

/// Undirected edges, each with the sides of all its faces.
class EdgeTable {
 public:
  /// @param usable one flag per triangle; unusable ones are left out. Usable triangles name three
  ///        different vertices below vertex_count.
  EdgeTable(std::span<const Triangle> triangles, const std::vector<bool>& usable,
            std::size_t vertex_count);
  /// Edges of all faces, which must be usable.
  explicit EdgeTable(const TriangleSoup& soup);

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

/// A face with its vertices in ascending order.
struct SortedFace {
  Triangle vertices;
  bool even;  ///< `vertices` is an even permutation of the face's order
  Index face;
};

/// Returns the usable faces, those with the same vertices adjacent and in order of their indices.
std::vector<SortedFace> sort_faces(std::span<const Triangle> triangles,
                                   const std::vector<bool>& usable);

/// Returns, for each half-edge, its twin in the other face if its edge has exactly two faces that
/// run along it in opposite directions, as in solvers/core/mesh.h; otherwise kNone.
std::vector<Index> pair_half_edges(std::span<const Triangle> triangles, const EdgeTable& edges);

/// Joins the corners of each fan: corners at one vertex whose faces are connected across its edges.
/// @param twins the result of `pair_half_edges`
DisjointSets join_fans(std::span<const Index> twins);

/// Joins the vertices that faces connect.
/// @param usable one flag per triangle
DisjointSets join_vertices(std::span<const Triangle> triangles, const std::vector<bool>& usable,
                           std::size_t vertex_count);

/// Returns one flag per vertex: whether a face uses it.
std::vector<bool> used_vertices(std::span<const Triangle> triangles, std::size_t vertex_count);

/// Returns one flag per vertex: whether it lies on an edge along which no face runs in the opposite
/// direction.
std::vector<bool> boundary_vertices(const TriangleSoup& soup);

/// Returns one flag per triangle: whether it is a face, and not left out.
std::vector<bool> faces_of(const TriangleSoup& soup);

/// Returns one flag per vertex: whether it is a corner of a triangle that is left out although it
/// did not collapse. Such a vertex has a face in the file, if not in the mesh.
std::vector<bool> avoided_vertices(const TriangleSoup& soup);

/// Returns the mesh without the triangles that are left out, so that the numbers of faces close up.
TriangleSoup without_left_out(TriangleSoup soup);

/// Returns the vertices and faces that the mesh was built from. A triangle that is left out has no
/// corners: three times vertex 0.
TriangleSoup soup_of(const Mesh& mesh);

/// Joins two meshes as separate components: the elements of the second follow those of the first.
TriangleSoup side_by_side(TriangleSoup first, const TriangleSoup& second);

/// Returns the first face of each set of usable faces that vertices connect, in order.
std::vector<Index> first_faces(std::span<const Triangle> triangles, const std::vector<bool>& usable,
                               std::size_t vertex_count);

/// Removes the flagged faces; the others keep their order.
/// @return the number removed
std::size_t drop_faces(TriangleSoup& soup, const std::vector<bool>& dropped);

/// The flips that orient the faces that are connected across edges of exactly two faces.
struct Orientation {
  std::vector<bool> flipped;  ///< one flag per triangle: its direction must be reversed
  std::size_t flips = 0;
  /// Edges whose two faces have opposite directions in every orientation: the surface has one side
  /// only, like a Moebius strip. 0 for an orientable surface.
  std::size_t one_sided_edges = 0;
};

/// Traverses each connected part breadth-first from its triangle of least index, which keeps its
/// direction. Sides are visited in the order of their half-edges: the result is deterministic.
Orientation orient(std::span<const Triangle> triangles, const EdgeTable& edges);

/// Returns the triangle in reverse direction, from the same first vertex.
inline Triangle flip(const Triangle& t) { return {t[0], t[2], t[1]}; }

}  // namespace geodesic
