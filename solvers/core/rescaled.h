// A solver on a mesh in an extreme unit of length, by way of an ordinary one.
#pragma once

#include <memory>

#include "solvers/core/registry.h"

namespace geodesic {

/// Prepares a solver for the mesh in units of 2^exponent, and translates queries, distances and
/// recordings. Answers have the bits that the same mesh would have in that unit, but for their
/// exponents.
/// @param exponent unit_exponent of the mesh's positions
std::unique_ptr<Solver> make_rescaled(const Mesh& mesh, const Description& description,
                                      const SolverFactory& factory, int exponent);

}  // namespace geodesic
