// Which vertices a mesh is solved from: chosen by a seed, the same for every solver.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// Chooses distinct source vertices, never one that no face has: vertex 0 first where it can be,
/// then a random boundary vertex where there is one, then random ones. Fewer sources are a prefix
/// of more.
/// @param mesh the mesh's name, so that meshes of one size get different vertices
/// @param count at least 1
/// @return count vertices, or all that there are
std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed);

}  // namespace geodesic::harness
