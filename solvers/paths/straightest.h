// Straightest lines, which go on from a point in a direction, and polar coordinates around a
// source.
//
// A direction is an angle in radians, counter-clockwise seen from the side to which the faces are
// oriented, measured on the surface. At a point in a face it begins at the direction from the
// face's corner 0 to its corner 1. At a vertex it begins at the side of its face of least number,
// or at the boundary edge where the fan of that face begins; it goes through the angles of all
// faces, the total angle of the vertex, which is 2 pi only where the surface is flat.
#pragma once

#include <vector>

#include "solvers/core/path.h"
#include "solvers/paths/paths.h"

namespace geodesic {

/// A line that is straight in each face and across each edge.
struct StraightestLine {
  std::vector<PathPoint> points;  ///< from its begin, as in Path
  bool ends_at_boundary = false;  ///< it is shorter than requested

  double length() const { return points.back().travelled; }
};

/// The sum of the angles of the faces at a vertex; 2 pi at any other point.
/// @throws std::invalid_argument for a point that is not of this mesh
double total_angle(const Mesh& mesh, const SurfacePoint& point);

/// The angle of a vector, which is projected to the face of the point. At a vertex it is projected
/// to the plane across the mean of the faces' normals, weighted by their angles; there it lies
/// between two edges, whose angle on the surface it divides in the same ratio.
/// @throws std::invalid_argument for a point that is not of this mesh or has no face with an area,
///         a vector that has no such projection, and one that leads off the surface at a boundary
double angle_of(const Mesh& mesh, const SurfacePoint& begin, const Vec3& vector);

/// Goes on from a point in a direction. At a vertex the line leaves the same angle on both sides
/// (Polthier and Schmies 1998, "Straightest geodesics on polyhedral surfaces", definition 1). It
/// ends after this length, or at the boundary.
/// @param angle taken modulo the total angle
/// @param length from 0 to 10^7 times the mean edge length, in the mesh's unit of length
/// @throws std::invalid_argument for a point that is not of this mesh or a vertex without a face,
///         an angle that is not finite, another length, and a mesh whose paths cross non-manifold
///         edges: its faces have no orientation
StraightestLine trace_straightest(const Mesh& mesh, const SurfacePoint& begin, double angle,
                                  double length);

/// Polar coordinates of a vertex around the source of its shortest path.
struct PolarCoordinates {
  double length = kInfinity;  ///< its distance
  /// The direction in which the path leaves the source, 0 at a source itself; not a number where no
  /// path leads and where the path leaves the surface (approximate solvers).
  double angle;
};

/// The discrete logarithmic map: polar coordinates of every vertex, by external number. Beyond a
/// saddle vertex, where paths bend, all vertices of its shadow have the angle of the path to it.
/// @throws std::invalid_argument for a mesh whose paths cross non-manifold edges, and for a source
///         at an end of an edge without a length
std::vector<PolarCoordinates> log_map(const Paths& paths);

}  // namespace geodesic
