// The mesh that is edited: what changes a mesh's connectivity goes over this half-edge mesh.
//
// OpenMesh's mesh is a manifold of oriented faces. Sheets that meet in an edge of more faces, or in
// one vertex, are separated before (separate_sheets): each then has vertices of its own.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "meshes/repair.h"
#include "solvers/core/geometry.h"

namespace geodesic {

struct EditedMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  // Status: elements can be deleted.
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};

/// Vertex i, face f and corner k of a face have the numbers of the soup that it was made from;
/// what is added follows.
using EditedMesh = OpenMesh::TriMesh_ArrayKernelT<EditedMeshTraits>;

inline Vec3 to_vec3(const EditedMesh::Point& p) { return {p[0], p[1], p[2]}; }
inline EditedMesh::Point to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

/// The point of a mesh's edge in its middle.
EditedMesh::Point middle_of(const EditedMesh& mesh, EditedMesh::EdgeHandle edge);

/// @param soup manifold and oriented, as `separate_sheets` leaves it
/// @throws std::logic_error when it is not
EditedMesh edited(const TriangleSoup& soup);

/// Gives each fan of faces at a vertex a vertex of its own, so that every edge has one face, or two
/// that run along it in opposite directions. The first fan keeps the vertex, copies follow all
/// others. Faces at an edge of three or more stay connected when they are in the same fans at both
/// of its ends: two tubes that touch along an edge come apart, a fin comes off.
/// @param soup faces of three different vertices
/// @return for each copy, in their order, the vertex that it was copied from
std::vector<Index> separate_sheets(TriangleSoup& soup);

/// How a repair that separated sheets is reported.
RepairAction separated(std::size_t copies);

}  // namespace geodesic
