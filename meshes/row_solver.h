// Solves from one source, or one set of sources, after the other: the rows of a distance matrix.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "meshes/point_solver.h"

namespace geodesic {

/// Gives every thread a solver, all with the same preparation.
class SolverForEachThread {
 public:
  explicit SolverForEachThread(PointSolver first)
      : first_(std::make_shared<PointSolver>(std::move(first))) {}

  /// Threads may call it at the same time.
  std::shared_ptr<PointSolver> next() {
    return is_taken_.test_and_set() ? std::make_shared<PointSolver>(first_->another()) : first_;
  }

 private:
  std::shared_ptr<PointSolver> first_;
  std::atomic_flag is_taken_;
};

/// A solver for one thread, with memory for its results. Copies share the solver.
class RowSolver {
 public:
  /// @param solver a solver on the mesh, with all later sources and the targets inserted
  /// @param asked the limit and the targets of all rows; its sources are ignored
  RowSolver(std::shared_ptr<PointSolver> solver, const Mesh& mesh, Query asked)
      : solver_(std::move(solver)),
        query_(std::move(asked)),
        distances_(mesh.vertex_count()),
        at_targets_(query_.targets.size()) {}

  /// As PointSolver::solve. Overwrites the results of the previous sources.
  void solve(std::vector<Source> sources) {
    query_.sources = std::move(sources);
    solver_->solve(query_, distances_, at_targets_);
  }

  /// Distances from the nearest of the last sources: of all vertices, and of the targets.
  std::span<const double> distances() const& { return distances_; }
  std::span<const double> at_targets() const& { return at_targets_; }
  /// The row of the last sources. Its columns are the targets; without targets, all vertices.
  std::span<const double> row() const& {
    return query_.targets.empty() ? distances() : at_targets();
  }
  // A temporary object takes them with it.
  std::span<const double> distances() const&& = delete;
  std::span<const double> at_targets() const&& = delete;
  std::span<const double> row() const&& = delete;

  InstructionSet instruction_set() const { return solver_->solver().instruction_set(); }

 private:
  std::shared_ptr<PointSolver> solver_;
  Query query_;
  std::vector<double> distances_, at_targets_;
};

}  // namespace geodesic
