// Generators that change the connectivity of a file's mesh, with OpenMesh.
#pragma once

#include <utility>

#include "meshes/editing/edited_mesh.h"
#include "meshes/editing/open_mesh.h"
#include "meshes/generators/families.h"

namespace geodesic {

/// Returns the mesh of the parameter "input" without isolated vertices, after
/// `change(EditedMesh&)`. A remark reports the sheets that had to be separated first.
/// @throws MeshError for the reasons of read_input
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
