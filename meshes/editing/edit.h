// Meshes made from the mesh of a file by changing its connectivity, over the mesh of OpenMesh.
#pragma once

#include <utility>

#include "meshes/editing/edited_mesh.h"
#include "meshes/editing/open_mesh.h"
#include "meshes/generators/families.h"

namespace geodesic {

/// The mesh of the parameter "input", without its isolated vertices, after `change(EditedMesh&)`. A
/// remark says so where sheets of its surface had to be separated before.
/// @throws MeshError as read_input
template <class Change>
GeneratedMesh edit_input(const CheckedParameters& parameters, const Change& change) {
  TriangleSoup soup = read_input(parameters);
  drop_isolated_vertices(soup);
  std::vector<std::string> remarks;
  if (const std::size_t copies = separate_sheets(soup).size(); copies > 0) {
    remarks.push_back(separated(copies).summary());
  }
  EditedMesh mesh = edited(soup);
  change(mesh);
  return {soup_of(mesh), std::move(remarks)};
}

}  // namespace geodesic
