// Making a mesh measurable: a documented, deterministic repair that never renumbers a vertex.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meshes/defects.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// One thing that a repair did.
struct RepairAction {
  std::string key;      ///< "flipped_faces", for JSON
  std::string text;     ///< "faces flipped to run the same way round as their neighbours"
  std::size_t count;    ///< never 0
  bool changed = true;  ///< false where the mesh stays as it is and only its meaning is settled
  std::optional<DefectKind> remedied = {};  ///< by `repair`: what was wrong
  /// "faces flipped to run the same way round as their neighbours: 2"
  std::string summary() const { return text + ": " + std::to_string(count); }
};

/// Repairs in place, in this order:
///  1. faces with an index out of range, faces that name a vertex twice and faces at a vertex
///     with a non-finite coordinate are dropped; such a vertex moves to the origin, where it is
///     isolated and unreachable;
///  2. of faces with the same three vertices (either way round) the first stays;
///  3. faces are flipped to run as their neighbours do, breadth-first from the face of least index
///     of each part that is connected across edges of exactly two faces; that face stays;
///  4. non-manifold edges, and edges along which a one-sided surface cannot be oriented, are cut:
///     the file's triangles stay, and the solvers' Mesh treats the edge as a boundary of each of
///     its faces, so that paths cross it at its end vertices only.
/// Everything else (zero-area faces, zero-length edges, non-manifold and isolated vertices, several
/// components) stays: the solvers handle it. Faces keep their order, and vertices their ids.
/// Repairing again changes nothing: it only settles the cuts of step 4 again.
/// @return what was done, empty for a mesh without errors
std::vector<RepairAction> repair(TriangleSoup& soup);

}  // namespace geodesic
