// Reduces the number of vertices of a mesh.
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <stdexcept>

#include "meshes/editing/edit.h"

namespace geodesic {
namespace {

void decimate_to(EditedMesh& mesh, std::size_t vertices) {
  OpenMesh::Decimater::DecimaterT<EditedMesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<EditedMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<EditedMesh>::Handle no_fold;
  decimater.add(quadric);
  decimater.add(no_fold);
  mesh.update_face_normals();
  decimater.initialize();
  decimater.decimate_to(vertices);
}

GeneratedMesh make_decimate(const CheckedParameters& parameters) {
  const Index vertices = parameters.integer("vertices");
  GeneratedMesh made =
      edit_input(parameters, [&](EditedMesh& mesh) { decimate_to(mesh, vertices); });
  const std::size_t left = made.soup.positions.size();
  if (left != vertices) {
    throw std::invalid_argument(
        "decimate: parameter vertices is " + ParameterValue(vertices).text() +
        ", but the mesh of " + parameters.text("input") +
        (left < vertices ? " has " : " cannot have fewer without folds or another topology than ") +
        ParameterValue(left).text() + "; choose " + (left < vertices ? "fewer" : "more"));
  }
  return made;
}

}  // namespace

Family decimate() {
  return {
      {.name = "decimate",
       .description =
           "a mesh of whose edges the one is collapsed that changes the surface "
           "least, boundaries too, until `vertices` are left (Garland and Heckbert 1997, Surface "
           "simplification using quadric error metrics)",
       .parameters = {input_parameter(),
                      integer_parameter("vertices", 1000, 4, 500000000, "that are left")}},
      make_decimate};
}

}  // namespace geodesic
