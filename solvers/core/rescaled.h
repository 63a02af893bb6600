// A solver on a mesh in an extreme unit of length, by way of an ordinary one.
#pragma once

#include <memory>

#include "solvers/core/registry.h"
#include "solvers/core/unit.h"

namespace geodesic {

/// Prepares a solver for the mesh measured in `unit`, and converts queries, distances and
/// recordings. Distances have the mantissas that the mesh would have in that unit.
std::unique_ptr<Solver> make_rescaled(const Mesh& mesh, const Description& description,
                                      const SolverFactory& factory, const Unit& unit);

}  // namespace geodesic
