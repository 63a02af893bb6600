// Finds the points of a surface that are nearest to places in space.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "solvers/core/mesh.h"
#include "solvers/core/surface_point.h"

namespace geodesic {

struct NearestPoint {
  SurfacePoint at;
  double distance;  ///< through space, in the mesh's unit of length
};

/// Searches a surface for the points that are nearest to places in space. The first search builds a
/// tree of boxes over the faces, in linear time and 16 bytes a face. Any number of threads may
/// search at the same time.
class NearestPointSearch {
 public:
  /// @param mesh must outlive this object
  explicit NearestPointSearch(const Mesh& mesh);
  explicit NearestPointSearch(const Mesh&& mesh) = delete;
  ~NearestPointSearch();

  const Mesh& mesh() const { return mesh_; }

  /// If several points are nearest, returns that of the face with the least internal number: the
  /// tree changes nothing but the time. Isolated vertices are not part of the surface.
  /// @throws std::invalid_argument if the place is not finite, or the mesh has no face
  NearestPoint nearest_to(const Vec3& place) const;

  /// "is 5 from the surface, whose nearest point is taken; ..." for a place that was probably meant
  /// in other units or axes: farther than 1% of the surface's longest side. Empty for a nearer one.
  /// @param distance of the place from the surface
  std::string remark_if_far(double distance) const;

 private:
  class Tree;
  const Tree& tree() const;

  const Mesh& mesh_;
  mutable std::once_flag built_;
  mutable std::unique_ptr<const Tree> tree_;
};

}  // namespace geodesic
