// Any solver asked of any points: by itself, or on a mesh that has the points as vertices.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "meshes/editing/inserted_points.h"
#include "solvers/core/registry.h"

namespace geodesic {

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
