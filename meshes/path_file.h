// Files of paths: JSON for programs, OBJ and PLY for viewers of meshes.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "meshes/messages.h"
#include "solvers/paths/paths.h"

namespace geodesic {

/// The bytes of a file of paths, in their order, by the extension of its path:
/// - .json: `{"paths": [{"source": 0, "length": 1.5, "points": [...]}]}`, from the source to the
///   end. A point has `"vertex": 12`, or `"face": 7, "weights": [...]` of its corners; `position`;
///   `travelled` along the path so far; and `next_face`, over which the path goes on, null at its
///   end.
/// - .obj: points as vertices, and one `l` with all of them a path.
/// - .ply: binary little-endian; vertices with x, y, z and travelled, edges between them with
///   vertex1, vertex2 and the number of their path.
///
/// Numbers as text have the digits that bring the same doubles back.
/// @throws MeshError for another extension, and for more points than a PLY file can number
std::string path_bytes(std::span<const Path> paths, const std::filesystem::path& file);

/// @throws MeshError as path_bytes, before there are any paths
void check_path_file(const std::filesystem::path& file);

}  // namespace geodesic
