// Points of a mesh's surface, where paths begin and end: vertices, points on edges and in faces.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/window.h"

namespace geodesic {

/// A vertex, or a point of a face, including its edges. External and internal numbers have separate
/// types, so that a function for one does not accept the other.
template <Numbers numbers>
struct PointIn {
  Index vertex = kNone;  ///< kNone: the point lies in a face
  Index face = kNone;    ///< kNone at a vertex
  /// Barycentric weights of the corners of `face`, in the order of its triangle: none is negative,
  /// their sum is 1, at most one is 0 (the point then lies on the edge opposite that corner).
  std::array<double, 3> weights = {};

  PointIn() = default;
  /// A plain number converts to an external vertex. An internal one must be constructed explicitly.
  explicit(numbers == Numbers::internal) PointIn(Index at_vertex)  // NOLINT: is a surface point
      : vertex(at_vertex) {}

  bool is_vertex() const { return vertex != kNone; }
  bool operator==(const PointIn&) const = default;
};
using SurfacePoint = PointIn<Numbers::external>;
using InternalPoint = PointIn<Numbers::internal>;

/// Returns the point of a face with these weights divided by their sum. It is a vertex when two of
/// them are 0.
/// @throws std::invalid_argument when the face is not in the mesh, a weight is negative or not
///        finite, or all are 0
SurfacePoint point_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights);

/// Returns the point on the edge from vertex a to vertex b, `share` of the way from a.
/// @throws std::invalid_argument when no edge joins them, or the share is not from 0 to 1
SurfacePoint point_on_edge(const Mesh& mesh, Index a, Index b, double share);

/// Position in space, in the mesh's unit of length.
/// @throws std::invalid_argument for a point that is not of this mesh
Vec3 position_of(const Mesh& mesh, const SurfacePoint& point);

/// Position of a point in internal numbers, which is not checked.
Vec3 position_of(const Mesh& mesh, const PointIn<Numbers::internal>& point);

/// Says what is wrong with a point on this mesh: "vertex 9 is not in the mesh of 8 vertices", after
/// "source " too; empty for a valid point. Every query is checked by it.
std::string defect_of(const Mesh& mesh, const SurfacePoint& point);

/// Converts a point to internal numbers.
/// @param point has no defect
InternalPoint in_internal_numbers(const Mesh& mesh, const SurfacePoint& point);

/// Converts a point to external numbers.
SurfacePoint in_external_numbers(const Mesh& mesh, const InternalPoint& point);

/// Position of a point of the face of half-edge h, in the frame of h: y >= 0.
/// @param point not a vertex, in that face
inline Point2 in_frame(const Mesh& mesh, const InternalPoint& point, Index h) {
  const HalfEdge& e = mesh.half_edge(h);
  const double head = point.weights[(h + 1) % 3], apex = point.weights[(h + 2) % 3];
  return {head * e.length + apex * e.apex_x, apex * e.apex_y};
}

/// The half-edge of the point's face that the point lies on; kNone in the interior of the face.
inline Index edge_under(const InternalPoint& point) {
  for (Index k = 0; k < 3; ++k) {
    if (point.weights[k] == 0) return 3 * point.face + (k + 1) % 3;
  }
  return kNone;
}

/// True when a source in the face of a half-edge, or at an end of it, is so near to the apex, at
/// this distance, that rounding turns the source's lines round the apex. Where the lines part there
/// may be a gap, so the apex must send out windows, whatever kind of vertex it is: its lines are as
/// long. The distance is compared with the sides of the face, up to a factor, because the test runs
/// for every neighbour of a vertex that sends out windows.
inline bool is_next_to_apex(const HalfEdge& e, double distance) {
  return distance < kNextToCorner * (e.length + std::abs(e.apex_x) + e.apex_y);
}

/// Returns the point in every face that contains it, first in its own. For a point on an edge that
/// includes the face beyond; if paths cross non-manifold edges, all faces of the edge and their
/// mirror images.
/// @param point not a vertex
std::vector<InternalPoint> in_every_face(const Mesh& mesh, const InternalPoint& point);

/// Moves a point of a mirror image into the given face; returns any other point unchanged.
InternalPoint in_given_face(const Mesh& mesh, const InternalPoint& point);

/// Follows all straight lines that leave a point through the corners and sides of every face that
/// contains it.
/// @param point not a vertex
/// @param reach called as (Index h, Point2 from, double distance, bool is_next) for each corner,
///        the apex of h: the point in the frame of h; its distance from the corner, accurate to all
///        digits of the weights, however small it is; and is_next_to_apex
/// @param cross called as (Index h, Point2 from) for each side on which the point does not lie,
///        since lines pass all of it: the point in the frame of the twin of h, with y <= 0 and kept
///        off the side as an apex is (apex_from_beyond). The twin may not exist.
template <class Reach, class Cross>
void spread_from(const Mesh& mesh, const InternalPoint& point, const Reach& reach,
                 const Cross& cross) {
  for (const InternalPoint& in_face : in_every_face(mesh, point)) {
    const Index under = edge_under(in_face);
    for (Index h = 3 * in_face.face; h < 3 * in_face.face + 3; ++h) {
      const Point2 from = in_frame(mesh, in_face, h);
      const Point2 from_apex = in_frame(mesh, in_face, Mesh::previous(h));
      const double to_apex = norm(from_apex);
      reach(h, from, to_apex, is_next_to_apex(mesh.half_edge(h), to_apex));
      if (h != under) cross(h, seen_from_beyond(from, mesh.half_edge(h).length));
    }
  }
}

}  // namespace geodesic
