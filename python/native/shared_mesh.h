// A mesh as Python objects and the threads of their calls share it, with solvers that wait for the
// next query.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "meshes/point_solver.h"
#include "solvers/core/mesh.h"

namespace geodesic::python {

/// Constant to its users; any number of threads may use it.
class SharedMesh {
 public:
  /// @throws std::invalid_argument as the constructor of Mesh does
  explicit SharedMesh(TriangleSoup soup,
                      NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut);

  const TriangleSoup& soup() const { return soup_; }
  NonManifoldEdges non_manifold_edges() const { return non_manifold_edges_; }

  /// The structure that solvers walk over, built by the first call: that takes as long as reading
  /// the arrays many times, and is best done where a user can interrupt it.
  const Mesh& mesh();

 private:
  friend class BorrowedSolver;

  const TriangleSoup soup_;
  const NonManifoldEdges non_manifold_edges_;
  std::once_flag built_;
  std::unique_ptr<const Mesh> mesh_;
  std::mutex mutex_;  // of all below
  std::string idle_name_;
  std::vector<std::unique_ptr<PointSolver>> idle_;  // of that name, on the mesh itself
};

/// A solver for one thread, from those that wait or prepared anew. It goes back to them at the end,
/// with the memory that it has, and replaces those of other names. One that an exception ends does
/// not, nor does one on a finer mesh.
class BorrowedSolver {
 public:
  /// @param name as of solver_named
  /// @param inserted as of PointSolver
  /// @throws std::invalid_argument as solver_named does, and when the mesh needs an ability that
  ///         the solver lacks
  BorrowedSolver(std::shared_ptr<SharedMesh> from, const std::string& name,
                 std::shared_ptr<const InsertedPoints> inserted = nullptr);
  ~BorrowedSolver();
  BorrowedSolver(const BorrowedSolver&) = delete;
  BorrowedSolver& operator=(const BorrowedSolver&) = delete;

  PointSolver& operator*() const { return *solver_; }
  PointSolver* operator->() const { return solver_.get(); }

 private:
  std::shared_ptr<SharedMesh> from_;
  std::string name_;  // canonical
  std::unique_ptr<PointSolver> solver_;
  bool goes_back_;
};

}  // namespace geodesic::python
