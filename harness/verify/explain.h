// Explains the first wrong distance by the windows that should have propagated the right one.
#pragma once

#include "harness/verify/property.h"

namespace geodesic::harness {

/// Violations on larger meshes are not explained: the path search unfolds all that a vertex sees.
inline constexpr Index kExplainedFaces = 2000;

/// Returns lines for debugging the solver: the wrong vertex with the least distance, the wrong and
/// the right distance, and the right path. The path is listed piece by piece from the source, with
/// the edges that it crosses and the windows at the crossings: those of another solver that keeps
/// its windows, and those of the solver itself if it keeps them.
/// @return empty when the violation has no distances or the mesh is too large; one line that says
///         so when the distances equal those of the reference
std::vector<std::string> explain_violation(const Description& solver, const Case& given,
                                           const Violation& violation);

}  // namespace geodesic::harness
