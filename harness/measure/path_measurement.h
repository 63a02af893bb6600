// What paths of a solver cost, and how long they are.
#pragma once

#include <span>
#include <string>

#include "harness/results/row.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Paths from a vertex to vertices all over the mesh (spread_vertices), on new solver objects.
/// @param solver one that claims paths, remembered or traced (Abilities)
/// @param count of the targets; fewer where fewer are reached
/// @param exact distances from the source, one a vertex
PathNumbers measure_paths(const Description& solver, const Mesh& mesh, Index source,
                          std::size_t count, std::span<const double> exact);

}  // namespace geodesic::harness
