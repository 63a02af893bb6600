// Writing a mesh file, whole or not at all.
#pragma once

#include <filesystem>

#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// Writes by extension: .obj and .off with the 17 digits that bring back the same doubles, .ply
/// binary little-endian with doubles. Vertices and faces keep their order.
/// @throws HarnessError for another extension, for an index out of range, and when the file cannot
///         be written
void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup);

}  // namespace geodesic::harness
