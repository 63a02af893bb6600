// Meshes whose geodesic distances have a closed form: written from plane geometry, no solver used.
#pragma once

#include <functional>

#include "solvers/core/geometry.h"

namespace geodesic::oracles {

/// A mesh together with the distance between any two of its vertices.
struct ClosedForm {
  TriangleSoup soup;
  std::function<double(Index, Index)> distance;
};

/// A rectangle of columns x rows unit cells, two triangles each, in a plane. Distances are
/// Euclid's. Unless it is shaken, most lines between vertices run exactly through others.
/// @param shake how far, in cells, vertices are moved pseudo-randomly within the plane (below 0.3;
///        those of the border move along it)
/// @param tilted turns the plane about two axes, so that coordinates get rounding errors
ClosedForm flat_grid(Index columns, Index rows, double shake = 0, bool tilted = false);

/// The closed surface of a box, each edge cut into `cells` parts. A shortest path is straight in
/// the unfolding of the faces it crosses, and crosses no face of a box twice.
ClosedForm box(const Vec3& size, Index cells);

/// `count` equal isosceles triangles around an apex (vertex 0), each cut into `levels` rows: a cone
/// with flat facets and an open rim. The distance follows from the angle between two vertices as
/// seen from the apex: a straight line below pi, else the way through the apex.
/// @param slope radians by which the triangles' legs leave the plane, all to one side
ClosedForm cone(Index count, double slope, Index levels);

/// As `cone`, the legs alternately above and below the plane: the angles at the apex sum to more
/// than 2 pi. @param count even
ClosedForm saddle(Index count, double slope, Index levels);

/// The side of a regular prism with `count` faces of unit width, open at both ends: a cylinder with
/// flat facets. It unrolls into a strip that repeats.
/// @param rows of unit height; @param columns cells in each face
ClosedForm cylinder(Index count, Index rows, Index columns);

/// A square of size x size unit cells without its middle hole x hole cells: paths bend at the
/// hole's corners. @param size - hole even
ClosedForm square_with_hole(Index size, Index hole);

}  // namespace geodesic::oracles
