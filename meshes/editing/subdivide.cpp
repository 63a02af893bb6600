// Splits faces into smaller ones. Old vertices keep their order.
#include <cstddef>  // OpenMesh's header needs it and does not include it

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>

#include "meshes/editing/edit.h"

namespace geodesic {
namespace {

/// Splits each face into four, with a new vertex at the middle of every edge. With smoothing,
/// vertices get the positions of Loop 1987, "Smooth subdivision surfaces based on triangles", and
/// boundaries those of a cubic B-spline curve; otherwise the surface stays the same.
void quarter(EditedMesh& mesh, bool smooths) {
  unsigned valence = 0;
  for (const auto v : mesh.vertices()) valence = std::max(valence, mesh.valence(v));
  OpenMesh::Subdivider::Uniform::LoopT<EditedMesh> loop;
  loop.init_weights(valence + 1);
  loop(mesh, 1, smooths);
}

/// Splits each face into six: the barycentric subdivision, with a new vertex at the centroid of
/// every face and at the middle of every edge.
void cut_at_centroids(EditedMesh& mesh) {
  const std::size_t edges = mesh.n_edges(), faces = mesh.n_faces();
  for (unsigned f = 0; f < faces; ++f) {
    mesh.split(mesh.face_handle(f), mesh.calc_face_centroid(mesh.face_handle(f)));
  }
  for (unsigned e = 0; e < edges; ++e) {
    mesh.split(mesh.edge_handle(e), middle_of(mesh, mesh.edge_handle(e)));
  }
}

GeneratedMesh make_subdivide(const CheckedParameters& parameters) {
  return edit_input(parameters, [&](EditedMesh& mesh) {
    for (const std::string& step : parameters.words("steps")) {
      const bool barycentric = step == "barycentric";
      check_face_count((barycentric ? 6.0 : 4.0) * static_cast<double>(mesh.n_faces()));
      if (barycentric) {
        cut_at_centroids(mesh);
      } else {
        quarter(mesh, step == "loop");
      }
    }
  });
}

}  // namespace

Family subdivide() {
  return {{.name = "subdivide",
           .description = "a mesh without its isolated vertices, its faces cut: midpoint makes 4 "
                          "faces of one and a vertex of "
                          "every edge, loop the same and smooths the surface, barycentric 6 "
                          "faces of one and a vertex of every edge and face",
           .parameters = {input_parameter(),
                          words_parameter("steps", {"midpoint", "loop", "barycentric"},
                                          "what to do, in this order")}},
          make_subdivide};
}

}  // namespace geodesic
