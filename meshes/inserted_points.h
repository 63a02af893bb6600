// Points of a mesh's surface as vertices of a finer mesh of the same surface, so that a solver that
// knows vertices only can be asked of them.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/core/registry.h"

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

  /// The vertex that a point became, as a given number.
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

/// The points that a solver cannot be asked of, inserted; null where it takes all (sources in faces
/// by Abilities::surface_sources, targets in faces by Abilities::paths).
/// @param sources, targets of all queries to come
/// @throws std::invalid_argument for a point that is not of this mesh
std::shared_ptr<const InsertedPoints> insert_for(const Description& solver, const Mesh& mesh,
                                                 std::span<const SurfacePoint> sources,
                                                 std::span<const SurfacePoint> targets);

/// Solves queries of any points by any solver: by the solver itself where it takes them, otherwise
/// on a mesh that has them as vertices.
class PointSolver {
 public:
  /// @param solver as of make_solver
  /// @param mesh outlives this object
  /// @param inserted from insert_for; may be shared by the solvers of several threads
  /// @throws std::invalid_argument as make_solver
  PointSolver(std::string_view solver, const Mesh& mesh,
              std::shared_ptr<const InsertedPoints> inserted = nullptr);
  /// @param sources, targets of all queries to come; @throws as insert_for too
  PointSolver(std::string_view solver, const Mesh& mesh, std::span<const SurfacePoint> sources,
              std::span<const SurfacePoint> targets)
      : PointSolver(solver, mesh, insert_for(solver_named(solver), mesh, sources, targets)) {}

  /// As Solver::solve. Distances of all vertices and targets are exact if the solver is.
  /// @param distances one entry a vertex of the given mesh
  /// @param at_targets one entry a target of the query, in their order
  void solve(const Query& query, std::span<double> distances, std::span<double> at_targets);

  Solver& solver() { return *solver_; }

 private:
  void solve_inserted(const Query& query, std::span<double> distances,
                      std::span<double> at_targets);
  void correct_near_sources(const Query& query, std::span<double> distances,
                            std::span<double> at_targets) const;

  const Description& description_;
  const Mesh& mesh_;
  std::shared_ptr<const InsertedPoints> inserted_;  // null where the solver takes all points
  std::unique_ptr<Solver> solver_;                  // on the finer mesh where there is one
  std::vector<double> finer_;                       // distances there
};

}  // namespace geodesic
