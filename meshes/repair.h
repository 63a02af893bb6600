// Repairs meshes for solvers: documented, deterministic, and without renumbering vertices.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meshes/defects.h"
#include "solvers/core/mesh.h"

namespace geodesic {

/// One kind of change that a repair made.
struct RepairAction {
  std::string key;      ///< "flipped_faces", for JSON
  std::string text;     ///< "faces flipped to run the same way round as their neighbours"
  std::size_t count;    ///< never 0
  bool changed = true;  ///< false if the mesh is unchanged and only its meaning was decided
  std::optional<DefectKind> remedied = {};  ///< the defect; set by `repair` only
  /// "faces flipped to run the same way round as their neighbours: 2"
  std::string summary() const { return text + ": " + std::to_string(count); }
};

/// Repairs a mesh in place, in this order:
///  1. faces with an index out of range, faces of fewer than three different vertices and faces at
///     a vertex with a non-finite coordinate are dropped; such a vertex moves to the origin, where
///     it is isolated and unreachable;
///  2. of faces with the same three vertices (either way round), only the first is kept;
///  3. faces are oriented like their neighbours, breadth-first from the face of least index of each
///     part that is connected across edges of exactly two faces; that face is not flipped;
///  4. non-manifold edges, and edges along which a one-sided surface cannot be oriented, are cut:
///     the file's triangles stay, and the solvers' Mesh treats the edge as a boundary of each of
///     its faces, so that paths cross it at its end vertices only. If paths are to cross such
///     edges, this step is left out.
/// All other defects (zero-area faces, zero-length edges, non-manifold and isolated vertices,
/// several components) stay: the solvers handle them. A repair joins no vertices: sheets that
/// touch, or a cut along which the surface ends, may be meant (see weld.h). Faces keep their order,
/// vertices their ids. A second repair changes nothing: it only reports the cuts of step 4 again.
/// @param non_manifold_edges as the constructor of Mesh will get it
/// @return the changes; empty for a mesh without errors
std::vector<RepairAction> repair(TriangleSoup& soup,
                                 NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut);

}  // namespace geodesic
