// Computes distances from vertex 0 of an OpenMesh mesh, and stores them as a vertex property.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <cstdio>

#include "meshes/editing/open_mesh.h"
#include "solvers/core/registry.h"

int main(int argc, char** argv) {
  OpenMesh::TriMesh_ArrayKernelT<> model;
  if (argc != 2 || !OpenMesh::IO::read_mesh(model, argv[1])) return 1;

  const geodesic::Mesh mesh(geodesic::soup_of(model), geodesic::Numbering::along_surface);
  std::vector<double> distances(mesh.vertex_count());
  geodesic::make_solver("edge-based", mesh)->solve({.sources = {{.at = 0}}}, distances);

  OpenMesh::VPropHandleT<double> distance;
  model.add_property(distance, "geodesic distance");
  geodesic::set_vertex_property(model, distance, distances);
  for (const auto v : model.vertices()) std::printf("%.17g\n", model.property(distance, v));
}
