// Points and triangles as plain data: what a mesh is built from.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace geodesic {

/// Index of a vertex, half-edge or face; 32 bits bound a mesh to about 1.4 * 10^9 faces.
using Index = std::uint32_t;

/// "No such element": the twin of a boundary half-edge, an unset vertex.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point or vector in space, in the unit of length of the file it came from.
using Vec3 = std::array<double, 3>;

/// Three vertex indices in counter-clockwise order seen from outside.
using Triangle = std::array<Index, 3>;

/// Triangles that share vertices by index; nothing is promised about their topology.
struct TriangleSoup {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

}  // namespace geodesic
