// A mesh that Python objects and the threads of their calls share, with the solvers of the last
// query.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "meshes/nearest_point.h"
#include "python/native/solver_pool.h"
#include "solvers/core/mesh.h"

namespace geodesic::python {

/// Immutable for its users. Any number of threads may use it.
class SharedMesh {
 public:
  /// @param mesh built from the soup, which is kept: of a welded mesh, the welded one
  SharedMesh(TriangleSoup soup, std::shared_ptr<const Mesh> mesh,
             NonManifoldEdges non_manifold_edges)
      : soup_(std::move(soup)), mesh_(std::move(mesh)), non_manifold_edges_(non_manifold_edges) {}

  const TriangleSoup& soup() const { return soup_; }
  const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }
  const NearestPointSearch& surface() const { return surface_; }
  NonManifoldEdges non_manifold_edges() const { return non_manifold_edges_; }

  /// The solvers of a name. They are kept until the pool of another name is requested.
  /// @throws std::invalid_argument for the reasons of solver_named
  std::shared_ptr<SolverPool> pool(const std::string& solver);

 private:
  const TriangleSoup soup_;
  const std::shared_ptr<const Mesh> mesh_;
  const NearestPointSearch surface_{*mesh_};
  const NonManifoldEdges non_manifold_edges_;
  std::mutex mutex_;  // guards the pool of the last name
  std::shared_ptr<SolverPool> pool_;
};

}  // namespace geodesic::python
