// The numberings of a mesh's vertices and faces: as given, or along the surface.
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

/// The numbering that vertex and face numbers belong to.
enum class Numbers {
  external,  ///< the given one: in files, queries, distances and paths
  internal   ///< positions in the mesh's memory: in functions of Mesh and in solvers
};

/// Converts between the two numberings of a mesh. The corners of a face keep their order.
///
/// Several external vertices may be names of one internal vertex (`join`). Answers by external
/// vertex are therefore gathered through `internal_vertex`, and never scattered through
/// `external_vertex`.
class MeshNumbers {
 public:
  /// Both numberings are the same.
  MeshNumbers() = default;
  /// @param given_vertices, given_faces external numbers, by internal number
  /// @param external_faces number of external faces; those that are not among the given ones have
  ///        no internal number
  MeshNumbers(std::vector<Index> given_vertices, std::vector<Index> given_faces,
              std::size_t external_faces);

  /// Makes each external vertex a name of the internal vertex of another one. Its own internal
  /// vertex, which must be isolated, stays in memory, so that both numberings have as many.
  /// @param joined_to by external vertex, as in TriangleSoup
  void join(std::span<const Index> joined_to);

  bool is_identity() const { return given_.empty(); }
  Index external_vertex(Index own) const { return given_.empty() ? own : given_[own]; }
  Index external_face(Index own) const { return given_faces_.empty() ? own : given_faces_[own]; }
  Index internal_vertex(Index given) const { return own_.empty() ? given : own_[given]; }
  /// kNone for a face that is left out.
  Index internal_face(Index given) const { return own_faces_.empty() ? given : own_faces_[given]; }

 private:
  std::vector<Index> given_, given_faces_;  // by internal number
  std::vector<Index> own_, own_faces_;      // by external number
};

/// A vertex and its cell: a box of 1/1024 of the bounding box of all vertices on the curve in each
/// direction.
struct OnCurve {
  std::uint32_t cell;  ///< its position on the curve in kCurveBits bits; each bit halves a box
  Index vertex;
};
inline constexpr unsigned kCurveBits = 30;

/// Returns some vertices in the order in which a space-filling curve meets them (Morton 1966, "A
/// computer oriented geodetic data base"). Those of one cell keep their given order; if they are
/// many, they are sorted in the same way in their own box. A radix sort: time and memory are
/// linear, times the number of such boxes inside each other.
/// @param positions of all vertices, finite
/// @param vertices those to sort. Isolated vertices should not be among them: their positions may
///        be far away and mean nothing.
std::vector<OnCurve> cells_along_curve(std::span<const Vec3> positions,
                                       std::span<const Index> vertices);

/// Faces in the order of their least vertex; those of one vertex keep their given order. Linear.
std::vector<Index> order_by_least_vertex(std::span<const Triangle> triangles, Index vertices);

}  // namespace geodesic
