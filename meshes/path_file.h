// Writes files of paths: JSON for programs, OBJ and PLY for mesh viewers.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "meshes/messages.h"
#include "solvers/paths/paths.h"

namespace geodesic {

/// Returns the bytes of a file with the paths, in order; the extension selects the format:
/// - .json: `{"paths": [{"source": 0, "length": 1.5, "points": [...]}]}`, from the source to the
///   end. A point has `"vertex": 12`, or `"face": 7, "weights": [...]` of the face's corners;
///   `position`; `travelled`, the length of the path so far; and `next_face`, the face that the
///   path crosses next, null at its end.
/// - .obj: points as vertices, and one `l` per path with all its points.
/// - .ply: binary little-endian; vertices with x, y, z and travelled; edges between them with
///   vertex1, vertex2 and the number of their path.
///
/// Numbers in text formats have enough digits to restore the same doubles.
/// @throws MeshError for another extension, and if a PLY file cannot number so many points
std::string path_bytes(std::span<const Path> paths, const std::filesystem::path& file);

/// Checks the extension before paths are computed. @throws MeshError for another extension
void check_path_file(const std::filesystem::path& file);

}  // namespace geodesic
