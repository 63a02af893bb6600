// Where rules that argue with angles must not be used.
#pragma once

#include <cstdint>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::chen_han {

/// Marks, one entry a vertex, the corners of faces without reliable angles (a zero-length edge, no
/// area up to rounding) and their neighbours. There, pseudo-sources coincide or lie in line: which
/// of them is nearer, and from where its path arrives, is chance, and a window may be dropped in
/// favour of one that was dropped in its favour. Marked vertices send windows into all their faces
/// and the corners of their faces have no owner; the filter alone stops windows there.
std::vector<std::uint8_t> find_unreliable_vertices(const Mesh& mesh);

}  // namespace geodesic::chen_han
