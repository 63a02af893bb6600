// Schemes that cut every face of a mesh into smaller ones.
//
// Any triangles will do: an edge is what its two vertices say, whichever way its faces run and
// however many they are, and an isolated vertex stays as it is. Old vertices keep their ids.
#pragma once

#include "solvers/core/geometry.h"

namespace geodesic {

/// Four faces from one, with a new vertex in the middle of every edge; the surface stays the same.
/// Face f becomes the faces 4 f to 4 f + 3, at its three corners and in its middle; the new
/// vertices are in order of the ids of their edges' ends, the smaller first.
/// @throws std::invalid_argument for more faces than an Index can number, like the others
TriangleSoup subdivide_midpoint(const TriangleSoup& soup);

/// The faces of subdivide_midpoint with the positions of Loop 1987, "Smooth subdivision surfaces
/// based on triangles". Edges of one face (boundaries) and of three or more are creases that become
/// a cubic B-spline curve; a vertex with one crease or more than two stays where it is.
TriangleSoup subdivide_loop(const TriangleSoup& soup);

/// Six faces from one: the barycentric subdivision, with a new vertex in the middle of every edge,
/// numbered as by subdivide_midpoint, and then one at the centroid of every face, in their order;
/// the surface stays the same. Face f becomes the faces 6 f to 6 f + 5, around its centroid.
TriangleSoup subdivide_barycentric(const TriangleSoup& soup);

}  // namespace geodesic
