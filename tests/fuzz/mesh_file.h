// A mesh file of any format, as `geodesic-bench mesh` and `solve` take it.
#pragma once

#include <string>
#include <string_view>

namespace geodesic::harness::fuzz {

/// Reads, describes, repairs and makes the mesh that a solver would get.
/// @param name its extension is a hint of the format
/// @throws MeshError for a file that is refused
void read_mesh_file(std::string_view bytes, const std::string& name);

}  // namespace geodesic::harness::fuzz
