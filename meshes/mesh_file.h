// Mesh files: OBJ, OFF (text, binary), PLY (ASCII, both binary orders) and STL (ASCII, binary) are
// read; OBJ, OFF and PLY are written.
//
// Vertex ids are the order of the vertices in the file, from 0, and isolated vertices stay; an STL
// file has no vertices of its own, so equal corners are joined and numbered by first appearance.
// Polygons and strips become triangles, in order. Coordinates are the doubles nearest to the
// decimal numbers of the file, in any locale. Topology is not checked: see defects.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/messages.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// Lines of the elements of a text file, counted from 1; both empty for a binary file.
struct FileLines {
  std::vector<std::uint32_t> vertices;   ///< one a vertex
  std::vector<std::uint32_t> triangles;  ///< one a triangle
};

struct MeshFile {
  TriangleSoup soup;   ///< indices out of range and non-finite coordinates are kept as they are
  std::string format;  ///< "OBJ", "OFF", "PLY ASCII", "PLY binary big-endian", "STL binary", ...
  FileLines lines;
  std::vector<std::string> warnings;  ///< one line each, without the file's name
};

/// All bytes of a regular file.
/// @throws MeshError when it cannot be read
std::string read_bytes(const std::filesystem::path& path);

/// ".obj" of a name that ends so in letters of either case; empty when it has no extension.
std::string lower_extension(const std::filesystem::path& file);

/// Whether the file's name ends in .obj, .off, .ply or .stl, in letters of either case.
bool has_mesh_extension(const std::filesystem::path& file);

/// Reads a file; its format is recognised by its content, the extension is only a hint.
/// @throws MeshError when the file cannot be read, is of no known format, malformed or truncated,
///         or holds no vertex or no face, or more than a Mesh can number
MeshFile read_mesh_file(const std::filesystem::path& path);

/// As `read_mesh_file` on a file's bytes.
/// @param name of the file, for messages; its extension is the hint
MeshFile parse_mesh(std::string_view bytes, const std::string& name);

/// The bytes of a mesh file, by the extension of its path: .obj and .off with the 17 digits that
/// bring the same doubles back, .ply binary little-endian with doubles. Vertices and faces keep
/// their order.
/// @throws MeshError for another extension and for an index out of range
std::string mesh_bytes(const TriangleSoup& soup, const std::filesystem::path& path);

}  // namespace geodesic
