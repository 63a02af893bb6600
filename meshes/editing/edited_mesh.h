// The half-edge mesh of all functions that change the connectivity of a mesh.
//
// OpenMesh's mesh is a manifold of oriented faces. Sheets that meet in a non-manifold edge or in
// one vertex must be separated first (separate_sheets): then each sheet has its own vertices.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "meshes/repair.h"
#include "solvers/core/geometry.h"

namespace geodesic {

struct EditedMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  // With a status, elements can be deleted.
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};

/// Vertex i, face f and corner k of a face have the numbers of the soup that the mesh was built
/// from. New elements follow.
using EditedMesh = OpenMesh::TriMesh_ArrayKernelT<EditedMeshTraits>;

inline Vec3 to_vec3(const EditedMesh::Point& p) { return {p[0], p[1], p[2]}; }
inline EditedMesh::Point to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

/// The midpoint of an edge.
EditedMesh::Point middle_of(const EditedMesh& mesh, EditedMesh::EdgeHandle edge);

/// @param soup manifold and oriented, for example after `separate_sheets`
/// @throws std::logic_error if the soup is not manifold and oriented
EditedMesh edited(const TriangleSoup& soup);

/// Gives each fan of faces its own vertex. After that every edge has one face, or two faces that
/// run along it in opposite directions. The first fan keeps the vertex; copies follow all other
/// vertices. Faces at an edge of three or more stay connected if they are in the same fans at both
/// of its ends: two tubes that touch along an edge are separated, and a fin is detached.
/// @param soup faces of three different vertices
/// @return for each copy, in order, the vertex that it is a copy of
std::vector<Index> separate_sheets(TriangleSoup& soup);

/// Reports a repair that separated sheets.
RepairAction separated(std::size_t copies);

}  // namespace geodesic
