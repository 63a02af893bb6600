// The locally shortest curve in the class of a given one: what the curve becomes when it is pulled
// tight over the surface.
//
// A class holds all curves into which the given one can be moved over the surface, with its ends in
// place if it is not closed. It may pass over vertices inside the surface, but not over a boundary.
// The idea is that of Xin and Wang 2007, "Efficiently determining a locally exact shortest path on
// polyhedral surfaces": the shortest line in the sleeve of the curve, which bends at vertices; a
// vertex where the angle outside the sleeve is less than pi is passed on its other side; and again,
// until there is none. Each time the length decreases.
#pragma once

#include "solvers/core/path.h"

namespace geodesic {

/// Returns a curve that is straight in each face and across each edge. At each vertex on its way
/// the angle on both sides is at least pi, or one of the sides is off the surface. It depends only
/// on the curve, and is not always the shortest one of its class.
/// @param curve with a face between every two points; it may cross itself
/// @param closed its last point is its first one; so is the result's, which may begin elsewhere
/// @throws std::invalid_argument if the closed curve shrinks to a point, the mesh's paths cross
///         non-manifold edges, the mesh has faces without area, which have no angles, or the curve
///         leaves the surface
/// @throws std::runtime_error if rounding keeps it from an end
Path straightened(const Mesh& mesh, const Path& curve, bool closed);

}  // namespace geodesic
