// Geodesic distances in closed form, one function a shape, from plane geometry alone.
//
// Each gives the distances of all vertices from `source`, in the unit of the positions, for the
// mesh that the shape's generator makes with these parameters. The formulas are applied to the
// stored positions in `long double`: rounding of a position (1e-16 of the mesh's size) is then part
// of the mesh that is measured, and results are good to the last bit or two of a double. Only on
// cones and saddles does that rounding also bend faces by what no unrolled plane can show, up to
// 1e-16 of a vertex's distance from the apex.
#pragma once

#include <vector>

#include "meshes/generators/parameters.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// A convex piece of a plane: the straight line.
std::vector<double> plane_distances(const CheckedParameters& parameters, const TriangleSoup& soup,
                                    Index source);

/// The plane with a square hole: straight where the hole is not in the way, else by its corners
/// (the shortest paths of a visibility graph: Lozano-Perez, Wesley 1979).
std::vector<double> square_with_hole_distances(const CheckedParameters& parameters,
                                               const TriangleSoup& soup, Index source);

/// The least straight line over all unfoldings of a chain of sides. A shortest path crosses no side
/// of a box twice (Sharir, Schorr 1986: it crosses no face of a convex polyhedron twice).
std::vector<double> box_distances(const CheckedParameters& parameters, const TriangleSoup& soup,
                                  Index source);

/// Planar sectors around vertex 0, unrolled: a straight line where the lesser angle at the apex is
/// below 180 degrees, else the way through the apex. The corners of the rim are convex, so that the
/// straight line never leaves the mesh.
std::vector<double> fan_distances(const CheckedParameters& parameters, const TriangleSoup& soup,
                                  Index source);

/// The strip that the tube unrolls to, the shorter way round.
std::vector<double> cylinder_distances(const CheckedParameters& parameters,
                                       const TriangleSoup& soup, Index source);

}  // namespace geodesic
