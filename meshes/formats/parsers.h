// The parsers behind read.h, one source file a format. Each takes a whole file and throws
// MeshError.
#pragma once

#include <string>
#include <string_view>

#include "meshes/mesh_file.h"

namespace geodesic {

MeshFile parse_obj(std::string_view text, const std::string& name);
MeshFile parse_off(std::string_view text, const std::string& name);
MeshFile parse_ply(std::string_view bytes, const std::string& name);
MeshFile parse_stl_ascii(std::string_view text, const std::string& name);
MeshFile parse_stl_binary(std::string_view bytes, const std::string& name);

/// True when the size of the file is what a binary STL file's own count asks for.
bool has_size_of_binary_stl(std::string_view bytes);

}  // namespace geodesic
