// A mesh that Python objects and the threads of their calls share, with idle solvers for the next
// query.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "meshes/nearest_point.h"
#include "meshes/point_solver.h"
#include "solvers/core/mesh.h"

namespace geodesic::python {

/// Immutable for its users. Any number of threads may use it.
class SharedMesh {
 public:
  /// @param mesh built from the soup; the soup is kept as it was given
  SharedMesh(TriangleSoup soup, std::unique_ptr<const Mesh> mesh,
             NonManifoldEdges non_manifold_edges)
      : soup_(std::move(soup)), mesh_(std::move(mesh)), non_manifold_edges_(non_manifold_edges) {}

  const TriangleSoup& soup() const { return soup_; }
  const Mesh& mesh() const { return *mesh_; }
  const NearestPointSearch& surface() const { return surface_; }
  NonManifoldEdges non_manifold_edges() const { return non_manifold_edges_; }

 private:
  friend class BorrowedSolver;

  const TriangleSoup soup_;
  const std::unique_ptr<const Mesh> mesh_;
  const NearestPointSearch surface_{*mesh_};
  const NonManifoldEdges non_manifold_edges_;
  std::mutex mutex_;  // guards all members below
  std::string idle_name_;
  std::vector<std::unique_ptr<PointSolver>> idle_;  // of that name, without inserted points
};

/// A solver for one thread: an idle one or a new one. The destructor returns it to the idle solvers
/// with its memory and drops idle solvers of other names. A solver is not returned after an
/// exception, or when it has inserted points.
class BorrowedSolver {
 public:
  /// @param name as in solver_named
  /// @param inserted as in PointSolver
  /// @throws std::invalid_argument for the reasons of solver_named, and when the mesh needs an
  ///         ability that the solver lacks
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
