// The sleeve of a curve: the faces that it runs through, joined along the edges that it crosses. It
// is an abstract strip: a face may occur in it more than once.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solvers/core/path.h"

namespace geodesic {

/// Half-edges in the order in which a curve crosses them, each from its own face into its twin's.
/// The head lies on the left of the curve, the origin on its right.
using Crossings = std::vector<Index>;

/// The sleeve of a curve from one point to another.
struct Sleeve {
  InternalPoint begin, end;
  Index face = kNone;  ///< the first one; contains `begin`
  Crossings crossings;
};

/// Returns the sleeves of a curve, one after the other: several where the curve passes vertices
/// between two fans of faces, which it cannot leave. At other vertices on its way the sleeve goes
/// round the side of fewer radians, or the only side on which there are faces.
/// @param points with faces, as in Path; at least two
/// @throws std::invalid_argument if two successive faces do not meet in the point between them
std::vector<Sleeve> sleeves_of(const Mesh& mesh, std::span<const PathPoint> points);

/// Leads a sleeve on into the next one, which begins in its end.
/// @return false if the curve cannot leave the vertex between them
bool join(const Mesh& mesh, Sleeve& sleeve, const Sleeve& next);

/// Returns the crossings of a sleeve that ends where it begins and leads on into itself there;
/// nothing if the curve cannot leave that vertex.
std::optional<Crossings> closed(const Mesh& mesh, const Sleeve& sleeve);

/// Removes the parts of a sleeve that lead over an edge and back.
void cancel_returns(const Mesh& mesh, Crossings& crossings, bool is_cyclic);

/// As above, and removes crossings of edges on which an end lies.
void trim(const Mesh& mesh, Sleeve& sleeve);

/// The vertex at one end of a crossing.
inline Index vertex_beside(const Mesh& mesh, Index crossing, bool left) {
  return left ? mesh.head(crossing) : mesh.origin(crossing);
}

/// The angle at the vertex on this side, in radians, of the face that the crossing leaves.
double angle_before(const Mesh& mesh, Index crossing, bool left);

/// Whether a curve can be moved over a vertex: one closed fan of faces lies around it.
bool is_passable(const Mesh& mesh, Index v);

/// Returns crossings that lead round the other side of a vertex, and less often around it.
/// @param run crossings of edges at a passable vertex, all on this side of the curve
Crossings round_other_side(const Mesh& mesh, std::span<const Index> run, bool left);

}  // namespace geodesic
