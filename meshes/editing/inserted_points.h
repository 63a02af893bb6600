// Inserts points of a mesh's surface as vertices of a finer mesh of the same surface, for solvers
// that support vertices only.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/query.h"

namespace geodesic {

/// A mesh whose vertices include given points of another mesh. The surface is the same; a mesh far
/// from the origin of space is moved there, by a shift that loses no bit of any coordinate.
///
/// The position of a point is rounded to doubles, by less than `place()`. A point nearer than that
/// to a vertex, to another point or to an edge is taken to lie there. A point on an edge splits the
/// faces on both sides.
class InsertedPoints {
 public:
  /// Time and memory are linear in the mesh, and quadratic in the number of points in a face.
  /// @param points in the mesh's external numbers; any number per face or edge; they may repeat
  /// @throws std::invalid_argument if a point is not on this mesh (defect_of)
  InsertedPoints(const Mesh& mesh, std::span<const SurfacePoint> points);

  /// The finer mesh. Given vertices keep their external numbers; the new ones follow.
  const Mesh& mesh() const { return *mesh_; }

  /// 1.8e-15 times the mesh's largest coordinate: more than the rounding error of a point.
  double place() const { return place_; }

  /// The external number of the vertex at a point.
  /// @throws std::invalid_argument if the point was not inserted
  Index vertex(const SurfacePoint& point) const;

  /// Translates a query to the vertices of `mesh()`. @throws for the reasons of vertex
  Query translated(const Query& query) const;

 private:
  Index given_count_;  // number of given vertices
  double place_ = 0;
  std::unique_ptr<const Mesh> mesh_;
  std::vector<std::pair<SurfacePoint, Index>> vertices_;  // in order of points
};

}  // namespace geodesic
