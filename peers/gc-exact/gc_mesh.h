// The mesh as geometry-central keeps it: what its solvers are asked about.
#pragma once

#include <geometrycentral/surface/manifold_surface_mesh.h>
#include <geometrycentral/surface/vertex_position_geometry.h>

#include "peer.h"

namespace geodesic::peer {

inline std::vector<std::vector<std::size_t>> polygons(const Mesh& mesh) {
  std::vector<std::vector<std::size_t>> all;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Triangle corners = mesh.triangle(f);
    all.emplace_back(corners.begin(), corners.end());
  }
  return all;
}

/// Keeps the order of vertices and faces. Construction throws where it refuses the mesh.
struct GcMesh {
  explicit GcMesh(const Mesh& own) : mesh(polygons(own)), geometry(mesh) {
    for (Index v = 0; v < own.vertex_count(); ++v) {
      const Vec3& p = own.position(v);
      geometry.vertexPositions[v] = {p[0], p[1], p[2]};
    }
  }

  geometrycentral::surface::ManifoldSurfaceMesh mesh;
  geometrycentral::surface::VertexPositionGeometry geometry;
};

}  // namespace geodesic::peer
