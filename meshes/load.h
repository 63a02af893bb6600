// From a file to a mesh that solvers can take: reading, finding defects, refusing or repairing.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "meshes/defects.h"
#include "meshes/mesh_file.h"
#include "meshes/repair.h"
#include "solvers/core/mesh.h"

namespace geodesic {

struct LoadOptions {
  bool repair = false;  ///< repair what would be refused (see repair.h)
  /// crossed: non-manifold edges, and edges between inconsistently oriented faces, are no errors.
  /// Where a repair cuts them, no such edge is left.
  NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut;
  std::string repair_option = "--repair";  ///< how users ask for a repair, for messages
};

struct LoadedMesh {
  TriangleSoup soup;  ///< fit for the constructor of Mesh
  std::string format;
  DefectReport defects;               ///< of the file, before any repair
  std::vector<RepairAction> repairs;  ///< empty without LoadOptions::repair
  std::vector<std::string> warnings;  ///< one line each, without the file's name: defects, repairs
                                      ///< and what the parser noticed
};

/// @throws MeshError when the file cannot be read, and when it has errors among its defects and is
///         not to be repaired, or has no face left after the repair
LoadedMesh load_mesh(const std::filesystem::path& path, const LoadOptions& options = {});

/// As `load_mesh` on a file that has been read.
/// @param name of the file, for messages
LoadedMesh load_mesh(MeshFile file, const std::string& name, const LoadOptions& options);

struct BuiltMesh {
  LoadedMesh loaded;
  std::unique_ptr<Mesh> mesh;  ///< of loaded.soup, numbered along the surface
};

/// As `load_mesh`, and builds the mesh: while another thread looks for defects.
BuiltMesh build_mesh(const std::filesystem::path& path, const LoadOptions& options = {});

/// The errors among the defects, in one line; empty without any.
/// @param non_manifold_edges as of LoadOptions
std::string list_errors(const DefectReport& report, NonManifoldEdges non_manifold_edges);

/// Refuses what solvers should not be given.
/// @param soup after the repair, if any
/// @param defects of the file, before it
/// @param name of the file, for messages
/// @throws MeshError as `load_mesh`
void require_measurable(const TriangleSoup& soup, const DefectReport& defects,
                        const std::string& name, const LoadOptions& options);

}  // namespace geodesic
