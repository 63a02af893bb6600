// Splits the longest edge of a mesh at its middle, repeatedly.
#include <queue>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "meshes/editing/edit.h"

namespace geodesic {
namespace {

/// An edge in the queue, valid while it has this length: longest first, then least number.
struct Edge {
  double squared_length;
  int number;

  bool operator<(const Edge& other) const {  // later in the queue
    return std::tie(squared_length, other.number) < std::tie(other.squared_length, number);
  }
};

void refine_to(EditedMesh& mesh, std::size_t vertices) {
  check_face_count(2.0 * static_cast<double>(vertices) + static_cast<double>(mesh.n_faces()));
  std::priority_queue<Edge> longest;
  const auto enqueue = [&](EditedMesh::EdgeHandle edge) {
    longest.push({mesh.calc_edge_sqr_length(edge), edge.idx()});
  };
  for (const auto edge : mesh.edges()) enqueue(edge);
  while (mesh.n_vertices() < vertices) {
    const auto edge = mesh.edge_handle(static_cast<unsigned>(longest.top().number));
    longest.pop();
    // Half of the edge keeps its number; the other half and the edges across the faces are new.
    auto added = static_cast<unsigned>(mesh.n_edges());
    mesh.split(edge, middle_of(mesh, edge));
    enqueue(edge);
    for (; added < mesh.n_edges(); ++added) enqueue(mesh.edge_handle(added));
  }
}

GeneratedMesh make_refine(const CheckedParameters& parameters) {
  const Index vertices = parameters.integer("vertices");
  return edit_input(parameters, [&](EditedMesh& mesh) {
    if (vertices < mesh.n_vertices()) {
      throw std::invalid_argument(
          "refine: parameter vertices is " + ParameterValue(vertices).text() +
          ", but the mesh of " + parameters.text("input") + " has " +
          ParameterValue(mesh.n_vertices()).text() + " without the isolated ones; choose more");
    }
    refine_to(mesh, vertices);
  });
}

}  // namespace

Family refine() {
  return {{.name = "refine",
           .description = "a mesh without its isolated vertices whose longest edge is cut in the "
                          "middle until there are `vertices`; the surface stays the same",
           .parameters = {input_parameter(), integer_parameter("vertices", 100000, 3, 500000000,
                                                               "of the refined mesh")}},
          make_refine};
}

}  // namespace geodesic
