#include "python/native/shared_mesh.h"

#include <exception>
#include <utility>

#include "solvers/core/registry.h"

namespace geodesic::python {

BorrowedSolver::BorrowedSolver(std::shared_ptr<SharedMesh> from, const std::string& name,
                               std::shared_ptr<const InsertedPoints> inserted)
    : from_(std::move(from)), name_(solver_named(name).name), goes_back_(inserted == nullptr) {
  if (goes_back_) {
    const std::lock_guard lock(from_->mutex_);
    if (from_->idle_name_ == name_ && !from_->idle_.empty()) {
      solver_ = std::move(from_->idle_.back());
      from_->idle_.pop_back();
      return;
    }
  }
  solver_ = std::make_unique<PointSolver>(name_, from_->mesh(), std::move(inserted));
}

BorrowedSolver::~BorrowedSolver() {
  if (!goes_back_ || std::uncaught_exceptions() > 0) return;
  const std::lock_guard lock(from_->mutex_);
  if (from_->idle_name_ != name_) from_->idle_.clear();
  from_->idle_name_ = name_;
  from_->idle_.push_back(std::move(solver_));
}

}  // namespace geodesic::python
