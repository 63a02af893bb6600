// Points of a mesh's surface, where paths begin and end: vertices, points of edges and of faces.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/window.h"

namespace geodesic {

/// A vertex, or a point of a face, its edges included. Points of either numbering have a type of
/// their own, so that a function of one does not take the other.
template <Numbers numbers>
struct PointIn {
  Index vertex = kNone;  ///< kNone: the point lies in a face
  Index face = kNone;    ///< kNone at a vertex
  /// Barycentric, of the corners of `face` in the order of its triangle: none negative, sum 1, at
  /// most one of them 0 (the point then lies on the edge opposite to that corner).
  std::array<double, 3> weights = {};

  PointIn() = default;
  /// A number alone is an external one. An internal one is named as such.
  explicit(numbers == Numbers::internal) PointIn(Index at_vertex)  // NOLINT: is a surface point
      : vertex(at_vertex) {}

  bool is_vertex() const { return vertex != kNone; }
  bool operator==(const PointIn&) const = default;
};
using SurfacePoint = PointIn<Numbers::external>;
using InternalPoint = PointIn<Numbers::internal>;

/// The point of a face with these weights, which are divided by their sum; a vertex where two of
/// them are 0.
/// @throws std::invalid_argument when the face is not in the mesh, or a weight is negative or not
///         finite, or all are 0
SurfacePoint point_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights);

/// The point between two neighbours, `share` of the way from vertex a to vertex b.
/// @throws std::invalid_argument when no edge joins them, or the share is not from 0 to 1
SurfacePoint point_on_edge(const Mesh& mesh, Index a, Index b, double share);

/// In space, in the mesh's unit of length.
Vec3 position_of(const Mesh& mesh, const SurfacePoint& point);

/// The same of a point by internal numbers.
Vec3 position_of(const Mesh& mesh, const PointIn<Numbers::internal>& point);

/// What is wrong with a point of this mesh: "vertex 9 is not in the mesh of 8 vertices"; empty when
/// nothing is. Every query is checked by it.
std::string defect_of(const Mesh& mesh, const SurfacePoint& point);

/// The same point by its other numbers.
/// @param point without a defect
InternalPoint in_internal_numbers(const Mesh& mesh, const SurfacePoint& point);

/// The same, the other way.
SurfacePoint in_external_numbers(const Mesh& mesh, const InternalPoint& point);

/// A point of the face of half-edge h, in the frame of h: y >= 0.
/// @param point not a vertex, and of that face
inline Point2 in_frame(const Mesh& mesh, const InternalPoint& point, Index h) {
  const HalfEdge& e = mesh.half_edge(h);
  const double head = point.weights[(h + 1) % 3], apex = point.weights[(h + 2) % 3];
  return {head * e.length + apex * e.apex_x, apex * e.apex_y};
}

/// The half-edge of the point's face on which it lies, kNone inside the face.
inline Index edge_under(const InternalPoint& point) {
  for (Index k = 0; k < 3; ++k) {
    if (point.weights[k] == 0) return 3 * point.face + (k + 1) % 3;
  }
  return kNone;
}

/// True when a source in the face of a half-edge, or at an end of it, lies so near to its apex, at
/// this distance, that rounding turns the lines of the source round it: where they part there may
/// be a gap. The apex has to send out windows then, whatever vertex it is: its lines are as long.
/// Compared with the sides of the face, up to a factor: every neighbour of a vertex that sends out
/// windows is asked.
inline bool is_next_to_apex(const HalfEdge& e, double distance) {
  return distance < kNextToCorner * (e.length + std::abs(e.apex_x) + e.apex_y);
}

/// The same point in every face that it lies in, first in its own: on an edge, in the face beyond
/// it too, and where paths cross non-manifold edges, in all faces of the edge and in their mirror
/// images.
/// @param point not a vertex
std::vector<InternalPoint> in_every_face(const Mesh& mesh, const InternalPoint& point);

/// The point of a mirror image in the face itself; any other point as it is.
InternalPoint in_given_face(const Mesh& mesh, const InternalPoint& point);

/// Follows all straight lines that leave a point of a face through its corners and sides.
/// @param in_face not a vertex
/// @param reach called as (Index h, Point2 from, double distance, bool is_next) for each corner,
///        the apex of h: the point in the frame of h, how far it is from the corner, with all
///        digits that its weights have, however near that is, and is_next_to_apex
/// @param cross called as (Index h, Point2 from) for each side on which the point does not lie: the
///        lines pass all of it. The point in the frame of the twin of h: y <= 0, and off the side
///        as an apex is (apex_from_beyond). The twin may not exist.
template <class Reach, class Cross>
void spread_in_face(const Mesh& mesh, const InternalPoint& in_face, const Reach& reach,
                    const Cross& cross) {
  const Index under = edge_under(in_face);
  for (Index h = 3 * in_face.face; h < 3 * in_face.face + 3; ++h) {
    const Point2 from = in_frame(mesh, in_face, h);
    const Point2 from_apex = in_frame(mesh, in_face, Mesh::previous(h));
    const double to_apex = norm(from_apex);
    reach(h, from, to_apex, is_next_to_apex(mesh.half_edge(h), to_apex));
    if (h != under) cross(h, seen_from_beyond(from, mesh.half_edge(h).length));
  }
}

/// The same in every face that the point lies in.
template <class Reach, class Cross>
void spread_from(const Mesh& mesh, const InternalPoint& point, const Reach& reach,
                 const Cross& cross) {
  for (const InternalPoint& in_face : in_every_face(mesh, point)) {
    spread_in_face(mesh, in_face, reach, cross);
  }
}

}  // namespace geodesic
