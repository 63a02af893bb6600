// Cost and length of a solver's paths.
#pragma once

#include <span>
#include <string>

#include "harness/results/row.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Measures paths from a vertex to vertices all over the mesh (spread_vertices), on new solvers.
/// @param solver must claim paths, remembered or traced (Abilities)
/// @param count number of targets; fewer are used if fewer are reached
/// @param exact distances from the source, one for each vertex
PathNumbers measure_paths(const Description& solver, const Mesh& mesh, Index source,
                          std::size_t count, std::span<const double> exact);

}  // namespace geodesic::harness
