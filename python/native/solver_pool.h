// Solvers of one name on one mesh, with one preparation for all threads of all calls.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "meshes/point_solver.h"

namespace geodesic::python {

/// The first thread that needs a solver prepares it, while others wait. All further solvers are
/// made from this one (Solver::another). Any number of threads may use a pool.
class SolverPool {
 public:
  /// @param solver from solver_named
  /// @param inserted as in PointSolver
  SolverPool(std::shared_ptr<const Mesh> mesh, const Description& solver,
             std::shared_ptr<const InsertedPoints> inserted = nullptr)
      : mesh_(std::move(mesh)), solver_(solver), inserted_(std::move(inserted)) {}
  /// @param ready a solver on the mesh
  SolverPool(std::shared_ptr<const Mesh> mesh, std::unique_ptr<Solver> ready);

  const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }
  const Description& solver() const { return solver_; }

 private:
  friend class BorrowedSolver;
  std::shared_ptr<PointSolver> take();
  void give_back(std::shared_ptr<PointSolver> solver);

  const std::shared_ptr<const Mesh> mesh_;
  const Description& solver_;
  const std::shared_ptr<const InsertedPoints> inserted_;
  std::mutex mutex_;  // guards all members below; held while the first solver is prepared
  std::shared_ptr<PointSolver> first_;  // stays the same once it is prepared
  std::vector<std::shared_ptr<PointSolver>> idle_;
};

/// The given pool if its solver supports the points; otherwise a pool of solvers on a finer mesh
/// whose vertices include them.
/// @throws std::invalid_argument for the reasons of insert_for
std::shared_ptr<SolverPool> pool_for(const std::shared_ptr<SolverPool>& pool,
                                     std::span<const SurfacePoint> sources,
                                     std::span<const SurfacePoint> targets);

/// A solver for one thread. The destructor returns it to its pool with its memory. A solver is not
/// returned after an exception.
class BorrowedSolver {
 public:
  /// @throws std::invalid_argument when the mesh needs an ability that the solver lacks
  explicit BorrowedSolver(std::shared_ptr<SolverPool> from);
  ~BorrowedSolver();
  BorrowedSolver(const BorrowedSolver&) = delete;
  BorrowedSolver& operator=(const BorrowedSolver&) = delete;

  PointSolver& operator*() const { return *solver_; }
  PointSolver* operator->() const { return solver_.get(); }

 private:
  std::shared_ptr<SolverPool> from_;
  std::shared_ptr<PointSolver> solver_;
};

}  // namespace geodesic::python
