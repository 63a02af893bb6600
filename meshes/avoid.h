// Vertices and faces of a mesh that paths may not enter.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// What paths may not enter, in the numbers of the mesh: the wall between the hemispheres of a
/// cortex, the faces of a label.
struct Avoided {
  std::vector<Index> vertices = {};  ///< each stands for all its faces
  std::vector<Index> faces = {};
  /// Set if the numbers are those of the set flags of a mask: the length of the mask, which must be
  /// the number of vertices, or of faces.
  std::optional<std::size_t> vertex_flags = {}, face_flags = {};
};

/// Leaves out the avoided faces: the surface ends at them as at a boundary, and distances are those
/// of the mesh without them. No number changes (TriangleSoup::left_out). Corners of other faces
/// remain on the surface; a vertex whose faces are all avoided is then isolated. Linear time.
/// @param soup an avoided vertex that is joined to another one stands for the faces of both
/// @throws std::invalid_argument for a number that the mesh does not have, for a mask of another
///         length, for a list of numbers that seems to be a mask (more than two numbers, all 0 or
///         1), and when no face remains
void leave_out(TriangleSoup& soup, const Avoided& avoided);

}  // namespace geodesic
