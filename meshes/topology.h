// The half-edge topology of a mesh, held by OpenMesh.
//
// OpenMesh refuses faces at non-manifold edges and vertices, and its importer replaces them with
// isolated triangles of copied vertices. Here every surface fits: a vertex becomes one OpenMesh
// vertex a fan of faces around it (each has its id in the file), an edge of more than two faces
// one boundary edge a face, exactly as in solvers/core/mesh.h. What is left out or changed on the
// way is counted.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "meshes/messages.h"
#include "solvers/core/geometry.h"

namespace geodesic {

struct SurfaceTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<SurfaceTraits>;

struct Topology {
  /// Vertex v < vertices of the file is the file's vertex v, with its first fan (or isolated);
  /// further fans follow in the order of their first faces. Faces are in the order of the file,
  /// oriented consistently.
  Surface surface;
  OpenMesh::VPropHandleT<Index> file_vertex;  ///< id in the file of a vertex of the surface
  OpenMesh::FPropHandleT<Index> file_face;    ///< triangle of the file of a face of the surface

  std::size_t left_out_faces = 0;   ///< unusable ones (see FaceCensus): they have no topology
  std::size_t flipped_faces = 0;    ///< turned to run as their neighbours do
  std::size_t cut_edges = 0;        ///< undirected edges of more than two faces, or one-sided
  std::size_t one_sided_edges = 0;  ///< of the cut ones; 0 exactly when the surface is orientable
  std::size_t extra_fans = 0;       ///< vertices of the surface beyond those of the file

  bool orientable() const { return one_sided_edges == 0; }
};

/// Builds the half-edge structure in expected linear time, for any valences.
/// @throws MeshError for more half-edges than OpenMesh can number (2^31)
Topology build_topology(const TriangleSoup& soup);

/// Closed walks along edges that have a face on one side only.
std::size_t count_boundary_loops(const Surface& surface);

/// Parts that are connected across edges, without isolated vertices.
std::size_t count_pieces(const Surface& surface);

/// Groups of faces that are connected across edges or through vertices of the file: what a path can
/// reach. Without isolated vertices.
std::size_t count_components(const Topology& topology);

}  // namespace geodesic
