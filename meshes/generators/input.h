// The meshes that generators start from.
#pragma once

#include "meshes/generators/parameters.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// The parameter "input" of a generator that starts from a mesh file.
ParameterDescription input_parameter();

/// Reads the mesh of the parameter "input". Its topology may be anything: non-manifold, in several
/// components, with isolated vertices.
/// @throws HarnessError when the file cannot be read or is malformed, and for faces that
///         name a vertex twice or one that is not there, and coordinates that are not finite
TriangleSoup read_input(const CheckedParameters& parameters);

}  // namespace geodesic
