// Reads mesh files in the formats OBJ, OFF (text, binary), PLY (ASCII, both binary orders) and STL
// (ASCII, binary); writes OBJ, OFF and PLY.
//
// Vertices have the order of the file, with ids from 0, and isolated vertices stay. An STL file has
// no list of vertices: equal corners are joined and numbered by first appearance. Polygons and
// strips become triangles, in order. Coordinates are the doubles nearest to the decimal numbers of
// the file, in any locale. Topology is not checked: see defects.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/messages.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// Line numbers of the elements of a text file, from 1; both empty for a binary file.
struct FileLines {
  std::vector<std::uint32_t> vertices;   ///< one per vertex
  std::vector<std::uint32_t> triangles;  ///< one per triangle
};

struct MeshFile {
  TriangleSoup soup;   ///< may have indices out of range and non-finite coordinates
  std::string format;  ///< "OBJ", "OFF", "PLY ASCII", "PLY binary big-endian", "STL binary", ...
  FileLines lines;
  std::vector<std::string> warnings;  ///< one line each, without the file's name
};

/// Reads all bytes of a regular file.
/// @throws MeshError if it cannot be read
std::string read_bytes(const std::filesystem::path& path);

/// Returns the extension of a name in lower case, such as ".obj"; empty without an extension.
std::string lower_extension(const std::filesystem::path& file);

/// Returns whether the file's name ends in .obj, .off, .ply or .stl, in upper or lower case.
bool has_mesh_extension(const std::filesystem::path& file);

/// Reads a file. Its content determines the format; the extension is only a hint.
/// @throws MeshError if the file cannot be read, has an unknown format, is malformed or truncated,
///         has no vertex or no face, or has more elements than a Mesh can number
MeshFile read_mesh_file(const std::filesystem::path& path);

/// As `read_mesh_file`, for the bytes of a file.
/// @param name the file's name, for messages; its extension is the hint
MeshFile parse_mesh(std::string_view bytes, const std::string& name);

/// Returns the bytes of a mesh file; the extension of the path selects the format. OBJ and OFF have
/// 17 digits, which restore the same doubles; PLY is binary little-endian with doubles. Vertices
/// and faces keep their order. Triangles that are left out are not written; joined vertices are,
/// and no face names them.
/// @throws MeshError for another extension and for an index out of range
std::string mesh_bytes(const TriangleSoup& soup, const std::filesystem::path& path);

}  // namespace geodesic
