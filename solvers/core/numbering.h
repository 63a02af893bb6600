// How a mesh numbers its vertices and faces: as they were given, or along the surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// The order of a mesh's vertices and faces in memory.
enum class Numbering {
  as_given,
  along_surface,  ///< large meshes are solved faster, small ones no slower
};

/// Whose numbers vertices and faces go by.
enum class Numbers {
  external,  ///< those that the mesh was given them by: of files, queries, distances and paths
  internal   ///< their places in the mesh's memory: of every function of Mesh, and in solvers
};

/// Translates between the two numberings of a mesh.
/// The corners of a face keep their order.
class MeshNumbers {
 public:
  /// The two numberings are the same.
  MeshNumbers() = default;
  /// @param given_vertices, given_faces by internal number
  MeshNumbers(std::vector<Index> given_vertices, std::vector<Index> given_faces);

  bool is_identity() const { return given_.empty(); }
  Index external_vertex(Index own) const { return given_.empty() ? own : given_[own]; }
  Index external_face(Index own) const { return given_faces_.empty() ? own : given_faces_[own]; }
  Index internal_vertex(Index given) const { return own_.empty() ? given : own_[given]; }
  /// Found by search: for a few points of a query.
  Index internal_face(Index given) const;

 private:
  std::vector<Index> given_, given_faces_;  // by internal number
  std::vector<Index> own_;                  // by external number
};

/// A vertex and the cell that it lies in, of 1/1024 of the bounding box in each direction.
struct OnCurve {
  std::uint32_t cell;  ///< its place on the curve, kCurveBits bits: each one halves a box
  Index vertex;
};
inline constexpr unsigned kCurveBits = 30;

/// All vertices in the order in which a space-filling curve meets them (Morton 1966, "A computer
/// oriented geodetic data base"), those of one cell in their given order. Time and memory are
/// linear: a radix sort.
/// @param positions finite
std::vector<OnCurve> cells_along_curve(std::span<const Vec3> positions);

/// Faces in the order of their least vertex, those of one vertex in their given order; linear.
std::vector<Index> order_by_least_vertex(std::span<const Triangle> triangles, Index vertices);

}  // namespace geodesic
