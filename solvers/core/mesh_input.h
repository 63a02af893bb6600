// What the constructor of Mesh refuses, for who keeps its input and builds the mesh later.
#pragma once

#include <span>

#include "solvers/core/geometry.h"

namespace geodesic {

/// @throws std::invalid_argument as the constructor of Mesh does
void check_mesh_input(std::span<const Vec3> positions, std::span<const Triangle> triangles);

}  // namespace geodesic
