// How far the right answers themselves move when a mesh is rounded: what no bound may go below.
#pragma once

#include <ostream>

#include "tests/differential/differential.h"

namespace geodesic::differential {

/// Moves every coordinate of each mesh `times` times at random by up to half a unit in the last
/// place of the largest one, as a change of the unit of length or of the origin does, and prints
/// how far brute force's distances move: relative to themselves, and to the longest edge where that
/// is more than the tolerance. Meshes too large for brute force are passed over.
void perturb(const Request& request, unsigned times, std::ostream& report);

}  // namespace geodesic::differential
