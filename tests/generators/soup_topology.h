// Counts of a triangle soup, found in the plainest way.
#pragma once

#include <cstddef>

#include "solvers/core/geometry.h"

namespace geodesic::testing {

struct SoupTopology {
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;
  std::size_t repeated_half_edges = 0;  ///< 0 when manifold in its edges and oriented
  std::size_t isolated_vertices = 0;
  std::size_t components = 0;      ///< isolated vertices not counted
  std::size_t boundary_loops = 0;  ///< where no two loops share a vertex
  std::size_t saddles = 0;         ///< inner vertices of more than 360 degrees
  long euler_characteristic = 0;   ///< V - E + F, isolated vertices counted
  double volume = 0;               ///< signed; positive when a closed surface faces outwards
  double least_edge = kInfinity;
  double greatest_edge = 0;
};

SoupTopology topology_of(const TriangleSoup& soup);

}  // namespace geodesic::testing
