// Writes files of paths and of isolines: JSON for programs, OBJ and PLY for mesh viewers.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "meshes/isolines.h"
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

/// Returns the bytes of a file with isolines, in order, as `path_bytes` does:
/// - .json: `{"isolines": [{"level": 1.5, "closed": true, "length": 9.4, "points": [...]}]}`
/// - .obj: the lines of each level are in a group that is named as the level.
/// - .ply: vertices with x, y, z and level; edges with vertex1, vertex2 and the number of their
///   isoline.
///
/// A closed line has its first point twice in JSON, and one vertex for both in OBJ and PLY.
/// @throws MeshError for the reasons of `path_bytes`
std::string isoline_bytes(std::span<const Isoline> lines, const std::filesystem::path& file);

/// Checks the extension before lines are computed. @throws MeshError for another extension
void check_path_file(const std::filesystem::path& file);

}  // namespace geodesic
