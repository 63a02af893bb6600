// Loads a mesh for solvers from a file: reads it, finds defects, and rejects or repairs them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshes/avoid.h"
#include "meshes/defects.h"
#include "meshes/mesh_file.h"
#include "meshes/repair.h"
#include "meshes/weld.h"
#include "solvers/core/mesh.h"

namespace geodesic {

struct LoadOptions {
  bool repair = false;  ///< repair a mesh with errors instead of rejecting it (see repair.h)
  /// Joins vertices within this distance (see weld.h), before defects are searched for and
  /// repaired; not set: joins none.
  std::optional<double> weld = {};
  Avoided avoid = {};  ///< left out (see avoid.h), after the weld and before that search
  /// crossed: non-manifold edges, and edges between inconsistently oriented faces, are not errors,
  /// and a repair does not cut them.
  NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut;
  std::string repair_option = "--repair";  ///< option that requests a repair, for messages
  std::string weld_option = "--weld";      ///< option that requests a weld, for messages
};

struct LoadedMesh {
  TriangleSoup soup;  ///< valid for the constructor of Mesh
  std::string format;
  std::vector<RepairAction> welds;    ///< empty if no vertices were joined
  DefectReport defects;               ///< of the faces that are not avoided, after any weld and
                                      ///< before any repair
  std::vector<RepairAction> repairs;  ///< empty without LoadOptions::repair
  std::vector<std::string> warnings;  ///< one line each, without the file's name: welds, defects,
                                      ///< repairs and warnings of the parser
};

/// @throws MeshError if the file cannot be read, if `weld` is no distance, if `avoid` is not of
///         this mesh or leaves no face, if it has defects that are errors and `repair` is false, or
///         if no face remains after the repair
LoadedMesh load_mesh(const std::filesystem::path& path, const LoadOptions& options = {});

/// As above, for a file that was already read.
/// @param name the file's name, for messages
LoadedMesh load_mesh(MeshFile file, const std::string& name, const LoadOptions& options);

struct BuiltMesh {
  LoadedMesh loaded;
  std::unique_ptr<Mesh> mesh;  ///< built from loaded.soup, numbered along the surface
};

/// As `load_mesh`, and builds the mesh while another thread searches for defects.
BuiltMesh build_mesh(const std::filesystem::path& path, const LoadOptions& options = {});

/// As above, for a file that was already read.
/// @param name the file's name, for messages
BuiltMesh build_mesh(MeshFile file, const std::string& name, const LoadOptions& options);

/// Lists the defects that are errors, in one line; empty without errors.
/// @param non_manifold_edges as in LoadOptions
std::string list_errors(const DefectReport& report, NonManifoldEdges non_manifold_edges);

/// What to do about a defect that a weld remedies: "; --weld joins them". Empty for others.
/// @param weld_option as in LoadOptions
std::string remedy_of(const Defect& defect, const std::string& weld_option);

/// Lists the defects that a weld remedies, with their remedies, in one line; empty without them.
std::string list_seams(const DefectReport& report, const std::string& weld_option);

/// Joins the vertices of a file, and then leaves faces out, as the options say.
/// @param name the file's name, for messages
/// @return what the weld did
/// @throws MeshError for a distance that is negative or not finite, and as check_names and
/// leave_out
std::vector<RepairAction> weld_and_leave_out(MeshFile& file, const std::string& name,
                                             const LoadOptions& options);

/// Checks that a mesh is suitable for solvers.
/// @param soup the mesh after all that the options ask for
/// @param defects the defects of the file before the repair
/// @param name the file's name, for messages
/// @throws MeshError for the reasons of `load_mesh`
void require_measurable(const TriangleSoup& soup, const DefectReport& defects,
                        const std::string& name, const LoadOptions& options);

}  // namespace geodesic
