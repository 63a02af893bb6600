// Registered solvers as users name them, and the meshes they can do.
#pragma once

#include <string>

#include "solvers/core/solver.h"

namespace geodesic::harness {

/// @throws HarnessError for an unknown name, listing the known ones
const Description& solver_named(const std::string& name);

/// Why the solver declares that it cannot do this mesh; empty when it can.
std::string unsupported(const Description& solver, const Mesh& mesh);

}  // namespace geodesic::harness
