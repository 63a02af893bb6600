// Solves queries of any points with any solver: directly, or on a mesh whose vertices include them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/editing/inserted_points.h"
#include "solvers/core/registry.h"

namespace geodesic {

/// Inserts the points that a solver does not support; null if it supports all (sources in faces by
/// Abilities::surface_sources, targets in faces by Abilities::paths).
/// @param sources, targets of all later queries
/// @throws std::invalid_argument for a point that is not of this mesh
std::shared_ptr<const InsertedPoints> insert_for(const Description& solver, const Mesh& mesh,
                                                 std::span<const SurfacePoint> sources,
                                                 std::span<const SurfacePoint> targets);

/// Solves queries of any points with any solver: by the solver itself if it supports the points,
/// otherwise on a mesh whose vertices include them.
class PointSolver {
 public:
  /// @param solver as in make_solver
  /// @param mesh must outlive this object
  /// @param inserted from insert_for; may be shared by the solvers of several threads
  /// @throws std::invalid_argument for the reasons of make_solver
  PointSolver(std::string_view solver, const Mesh& mesh,
              std::shared_ptr<const InsertedPoints> inserted = nullptr);
  /// @param sources, targets of all later queries; @throws for the reasons of insert_for too
  PointSolver(std::string_view solver, const Mesh& mesh, std::span<const SurfacePoint> sources,
              std::span<const SurfacePoint> targets)
      : PointSolver(solver, mesh, insert_for(solver_named(solver), mesh, sources, targets)) {}

  /// @param ready supports all points of later queries
  explicit PointSolver(std::unique_ptr<Solver> ready)
      : mesh_(&ready->mesh()), solver_(std::move(ready)) {}

  /// Returns another object with the same preparation, for another thread (Solver::another).
  PointSolver another() const { return {*mesh_, inserted_, solver_->another()}; }

  /// As Solver::solve. Distances of all vertices and targets are exact if the solver is exact.
  /// @param distances one entry per vertex of the given mesh
  /// @param at_targets one entry per target of the query, in their order
  void solve(const Query& query, std::span<double> distances, std::span<double> at_targets);

  Solver& solver() { return *solver_; }

 private:
  PointSolver(const Mesh& mesh, std::shared_ptr<const InsertedPoints> inserted,
              std::unique_ptr<Solver> solver)
      : mesh_(&mesh), inserted_(std::move(inserted)), solver_(std::move(solver)) {}

  const std::string& name() const { return solver_->description().name; }
  void solve_inserted(const Query& query, std::span<double> distances,
                      std::span<double> at_targets);
  void correct_near_sources(const Query& query, std::span<double> distances,
                            std::span<double> at_targets) const;

  const Mesh* mesh_;
  std::shared_ptr<const InsertedPoints> inserted_;  // null if the solver supports all points
  std::unique_ptr<Solver> solver_;                  // on the finer mesh if there is one
  std::vector<double> finer_;                       // distances on the finer mesh
};

}  // namespace geodesic
