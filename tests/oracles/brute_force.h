// A slow and plain solver: the third opinion where two solvers differ.
#pragma once

#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::oracles {

/// Distances from vertex `source` to all vertices, for meshes of up to some hundred faces.
///
/// A geodesic is a chain of straight segments that bend at vertices. All straight segments between
/// vertices are found by unfolding every strip of faces that can be seen from a vertex, as long as
/// it lies nearer than the farthest vertex along edges; nothing else is pruned, and every vertex
/// may be a bend. The result is the shortest chain. Lengths are taken from the positions and kept
/// in `long double`; only the topology (twins) is the mesh's.
std::vector<double> brute_force_distances(const Mesh& mesh, Index source);

}  // namespace geodesic::oracles
