// Points of a mesh's surface as vertices of a finer mesh of the same surface, so that a solver that
// knows vertices only can be asked of them.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/query.h"

namespace geodesic {

/// A mesh in which some points of another one are vertices. The surface is the same; far from the
/// origin of space it is moved there, by a shift that no coordinate loses a bit by.
///
/// A point lies where its coordinates are doubles: less than `place()` away. Points nearer than
/// that to a vertex, to one another or to an edge are taken to lie there. A point on an edge splits
/// the faces on both sides.
class InsertedPoints {
 public:
  /// Time and memory are linear in the mesh, and within one face quadratic in its points.
  /// @param points in the mesh's given numbers; any number may lie in a face, on an edge, twice
  /// @throws std::invalid_argument when a point is not of this mesh (defect_of)
  InsertedPoints(const Mesh& mesh, std::span<const SurfacePoint> points);

  /// The given vertices keep their given numbers; the new ones follow.
  const Mesh& mesh() const { return *mesh_; }

  /// 1.8e-15 times the mesh's largest coordinate: above what rounding moves a point by.
  double place() const { return place_; }

  /// The vertex that a point became, as a external number.
  /// @throws std::invalid_argument when the point was not inserted
  Index vertex(const SurfacePoint& point) const;

  /// The same query of these vertices, for `mesh()`. @throws as vertex
  Query translated(const Query& query) const;

 private:
  Index given_count_;  // of vertices
  double place_ = 0;
  std::unique_ptr<const Mesh> mesh_;
  std::vector<std::pair<SurfacePoint, Index>> vertices_;  // in order of points
};

}  // namespace geodesic
