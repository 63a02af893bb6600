#include "python/native/shared_mesh.h"

namespace geodesic::python {

std::shared_ptr<SolverPool> SharedMesh::pool(const std::string& solver) {
  const Description& description = solver_named(solver);
  const std::lock_guard lock(mutex_);
  if (pool_ == nullptr || &pool_->solver() != &description) {
    pool_ = std::make_shared<SolverPool>(mesh_, description);
  }
  return pool_;
}

}  // namespace geodesic::python
