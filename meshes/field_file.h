// Files with a mesh and its distances, for programs that show them.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "meshes/messages.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// Whether the extension is one of `field_bytes`: .ply or .vtk.
bool has_field_extension(const std::filesystem::path& file);

/// Returns the bytes of a file with a mesh and the distance of each vertex; the extension selects
/// the format. Vertices and faces keep their order, numbers are doubles, unreachable vertices have
/// infinity.
/// - .ply: binary little-endian. The distance is the property `quality`, by which MeshLab colours.
/// - .vtk: the legacy format of VTK (ParaView, PyVista), binary, with the point data `distance`.
///
/// With sources, both have a number `source` too.
/// @param sources one for each vertex, kNone (written as -1) where no path leads; may be empty
/// @throws MeshError for another extension, and more elements than 31 bits number
/// @throws std::invalid_argument for another number of distances or of sources
std::string field_bytes(const TriangleSoup& soup, std::span<const double> distances,
                        std::span<const Index> sources, const std::filesystem::path& file);

/// The bytes of a PLY file: of `field_bytes`, or of a mesh alone if there are no distances.
std::string ply_bytes(const TriangleSoup& soup, std::span<const double> distances = {},
                      std::span<const Index> sources = {});

}  // namespace geodesic
