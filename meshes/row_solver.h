// Distances from one source after the other, each by itself: the rows of a matrix.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "meshes/point_solver.h"

namespace geodesic {

/// A solver for one thread with room for its answers. Copies share the solver.
class RowSolver {
 public:
  /// @param solver on the mesh; with what inserts all sources to come and the targets asked for
  /// @param asked limit and targets of all rows; its sources are not used
  RowSolver(std::shared_ptr<PointSolver> solver, const Mesh& mesh, Query asked)
      : solver_(std::move(solver)),
        query_(std::move(asked)),
        distances_(mesh.vertex_count()),
        at_targets_(query_.targets.size()) {}

  /// As PointSolver::solve; what was returned for the source before is overwritten.
  void solve(const Source& source) {
    query_.sources = {source};
    solver_->solve(query_, distances_, at_targets_);
  }

  /// Of the last source: of all vertices, and at the targets.
  std::span<const double> distances() const { return distances_; }
  std::span<const double> at_targets() const { return at_targets_; }
  /// A row: the targets are its columns, without targets all vertices are.
  std::span<const double> row() const {
    return query_.targets.empty() ? distances() : at_targets();
  }

  InstructionSet instruction_set() const { return solver_->solver().instruction_set(); }

 private:
  std::shared_ptr<PointSolver> solver_;
  Query query_;
  std::vector<double> distances_, at_targets_;
};

}  // namespace geodesic
