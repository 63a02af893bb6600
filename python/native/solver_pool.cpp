#include "python/native/solver_pool.h"

#include <exception>

namespace geodesic::python {

SolverPool::SolverPool(std::shared_ptr<const Mesh> mesh, std::unique_ptr<Solver> ready)
    : mesh_(std::move(mesh)),
      solver_(ready->description()),
      first_(std::make_shared<PointSolver>(std::move(ready))),
      idle_{first_} {}

std::shared_ptr<PointSolver> SolverPool::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::shared_ptr<PointSolver> solver = std::move(idle_.back());
      idle_.pop_back();
      return solver;
    }
    if (first_ == nullptr) {
      first_ = std::make_shared<PointSolver>(solver_.name, *mesh_, inserted_);
      return first_;
    }
  }
  return std::make_shared<PointSolver>(first_->another());
}

void SolverPool::give_back(std::shared_ptr<PointSolver> solver) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(solver));
}

std::shared_ptr<SolverPool> pool_for(const std::shared_ptr<SolverPool>& pool,
                                     std::span<const SurfacePoint> sources,
                                     std::span<const SurfacePoint> targets) {
  auto inserted = insert_for(pool->solver(), *pool->mesh(), sources, targets);
  if (inserted == nullptr) return pool;
  return std::make_shared<SolverPool>(pool->mesh(), pool->solver(), std::move(inserted));
}

BorrowedSolver::BorrowedSolver(std::shared_ptr<SolverPool> from)
    : from_(std::move(from)), solver_(from_->take()) {}

BorrowedSolver::~BorrowedSolver() {
  if (std::uncaught_exceptions() == 0) from_->give_back(std::move(solver_));
}

}  // namespace geodesic::python
