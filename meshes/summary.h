// Statistics of a mesh: counts, lengths, angles and topology.
#pragma once

#include <cstddef>
#include <optional>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Lengths in the mesh's unit.
struct EdgeLengths {
  double least = 0;
  double mean = 0;
  double greatest = 0;
};

/// Statistics of the surface of the usable faces (see FaceCensus). Elements are counted as in
/// solvers/core/mesh.h: an edge of more than two faces is a boundary edge of each of them.
/// Neighbouring faces count as oriented alike even if the file orients them differently.
struct MeshSummary {
  std::size_t vertices = 0;        ///< vertices of the file, including isolated ones
  std::size_t faces = 0;           ///< triangles of the file
  std::size_t left_out_faces = 0;  ///< unusable or avoided triangles of the file
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;
  std::size_t components = 0;  ///< groups of faces that edges or vertices connect
  std::size_t boundary_loops = 0;
  std::size_t isolated_vertices = 0;  ///< without a usable face, except those of avoided faces
  bool orientable = true;
  /// Sum of the genus of all parts: (2 parts - loops - Euler characteristic) / 2. A part is what
  /// edges connect, and boundary loops count as closed by discs. None if not orientable.
  std::optional<std::size_t> genus;
  std::optional<EdgeLengths> edge_lengths;  ///< none without usable faces
  /// In degrees, over the faces with an area; none without such faces.
  std::optional<double> smallest_angle;
  /// Interior vertices with a total angle above 2 pi (by kSaddleAngleExcess at least), where
  /// shortest paths may bend. Boundary vertices are not counted; paths may bend at all of them.
  std::size_t saddle_vertices = 0;
};

/// Computes the statistics in expected linear time, for any triangles and valences.
MeshSummary summarize(const TriangleSoup& soup);

}  // namespace geodesic
