#include "meshes/editing/edited_mesh.h"

#include <stdexcept>

#include "meshes/connectivity.h"

namespace geodesic {

EditedMesh::Point middle_of(const EditedMesh& mesh, EditedMesh::EdgeHandle edge) {
  const auto h = mesh.halfedge_handle(edge, 0);
  return 0.5 * (mesh.point(mesh.from_vertex_handle(h)) + mesh.point(mesh.to_vertex_handle(h)));
}

EditedMesh edited(const TriangleSoup& soup) {
  EditedMesh mesh;
  mesh.reserve(soup.positions.size(), 3 * soup.triangles.size() / 2, soup.triangles.size());
  for (const Vec3& p : soup.positions) mesh.add_vertex(to_point(p));
  const auto vertex = [&](Index v) { return mesh.vertex_handle(v); };
  for (const auto& [a, b, c] : soup.triangles) {
    if (!mesh.add_face(vertex(a), vertex(b), vertex(c)).is_valid()) {
      throw std::logic_error("a mesh to edit is not manifold");
    }
  }
  return mesh;
}

// One pass is enough. The faces of a fan have the same orientation and form a row; only the two
// ends of the row lack a neighbour. All faces at an edge (a, b) of the result are in the one fan of
// a. They are at most two, the ends of the row, and have opposite directions along the edge.
std::vector<Index> separate_sheets(TriangleSoup& soup) {
  DisjointSets fans = join_fans(pair_half_edges(soup.triangles, EdgeTable(soup)));
  std::vector<bool> has_fan(soup.positions.size(), false);
  std::vector<Index> originals;
  for (Index h = 0; h < 3 * soup.triangles.size(); ++h) {
    const Index first = fans.find(h);  // the least corner of the fan: handled before h
    Index& v = soup.triangles[h / 3][h % 3];
    if (first != h) {
      v = origin_of(soup.triangles, first);
    } else if (has_fan[v]) {
      originals.push_back(v);
      const Vec3 position = soup.positions[v];
      v = static_cast<Index>(soup.positions.size());
      soup.positions.push_back(position);
    } else {
      has_fan[v] = true;
    }
  }
  return originals;
}

RepairAction separated(std::size_t copies) {
  return {"copied_vertices", "copies made of vertices at which separate sheets of the surface met",
          copies};
}

}  // namespace geodesic
