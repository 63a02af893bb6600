// Where a distance went wrong first, and the windows that should have carried the right one there.
#pragma once

#include "harness/verify/property.h"

namespace geodesic::harness {

/// Larger meshes are not explained: a path is found by unfolding all that a vertex sees.
inline constexpr Index kExplainedFaces = 2000;

/// Lines for the person who debugs the solver: the wrong vertex with the least distance, both
/// distances, and the path that should have got there, piece by piece from the source, with the
/// edges that it crosses and the windows that hold there: those of another solver that hands its
/// windows over, and the solver's own if it does.
/// @return empty when the violation is not one of distances, or the mesh is too large; a line that
///         says so when the distances are those of the reference
std::vector<std::string> explain_violation(const Description& solver, const Case& given,
                                           const Violation& violation);

}  // namespace geodesic::harness
