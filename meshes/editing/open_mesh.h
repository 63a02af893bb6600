// Converts OpenMesh's triangle meshes to meshes of this library, for programs that have such a mesh
// and for meshes/editing. Header only; the library itself does not need OpenMesh.
//
//   geodesic::Mesh mesh(geodesic::soup_of(model));
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Returns the vertices and faces that are not deleted, in the order of their handles: vertex i of
/// the result is the i-th of `mesh.vertices()`. Every face keeps its first corner.
/// @tparam TriMesh any OpenMesh::TriMesh_ArrayKernelT; coordinates are copied unchanged
template <class TriMesh>
TriangleSoup soup_of(const TriMesh& mesh) {
  TriangleSoup soup;
  std::vector<Index> number(mesh.n_vertices());
  soup.positions.reserve(mesh.n_vertices());
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    number[static_cast<std::size_t>(v.idx())] = static_cast<Index>(soup.positions.size());
    soup.positions.push_back({double{p[0]}, double{p[1]}, double{p[2]}});
  }
  soup.triangles.reserve(mesh.n_faces());
  for (const auto f : mesh.faces()) {
    auto corner = mesh.cfv_begin(f);
    const auto next = [&] { return number[static_cast<std::size_t>((corner++)->idx())]; };
    soup.triangles.push_back({next(), next(), next()});
  }
  return soup;
}

/// Stores one number per vertex, such as its distance, as a property of the mesh's vertices.
/// @param values one per vertex, in the order of `soup_of`
/// @throws std::invalid_argument if the numbers of values and vertices differ
template <class TriMesh>
void set_vertex_property(TriMesh& mesh, OpenMesh::VPropHandleT<double> property,
                         std::span<const double> values) {
  std::size_t i = 0;
  for (const auto v : mesh.vertices()) {
    if (i < values.size()) mesh.property(property, v) = values[i];
    ++i;
  }
  if (i != values.size()) {
    throw std::invalid_argument("a mesh of " + std::to_string(i) + " vertices got " +
                                std::to_string(values.size()) + " values");
  }
}

}  // namespace geodesic
