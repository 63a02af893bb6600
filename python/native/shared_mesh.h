// A mesh as Python objects and the threads of their calls share it, with solvers that wait for the
// next query.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "meshes/point_solver.h"
#include "solvers/core/mesh.h"

namespace geodesic::python {

/// Constant to its users; any number of threads may use it.
class SharedMesh {
 public:
  /// @param mesh of the soup, which is kept as it was given
  SharedMesh(TriangleSoup soup, std::unique_ptr<const Mesh> mesh,
             NonManifoldEdges non_manifold_edges)
      : soup_(std::move(soup)), mesh_(std::move(mesh)), non_manifold_edges_(non_manifold_edges) {}

  const TriangleSoup& soup() const { return soup_; }
  const Mesh& mesh() const { return *mesh_; }
  NonManifoldEdges non_manifold_edges() const { return non_manifold_edges_; }

 private:
  friend class BorrowedSolver;

  const TriangleSoup soup_;
  const std::unique_ptr<const Mesh> mesh_;
  const NonManifoldEdges non_manifold_edges_;
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
