// The windows that a solve ends with, for those who want distances between the vertices too.
#pragma once

#include <functional>
#include <vector>

#include "solvers/core/window.h"

namespace geodesic {

/// Gives the windows that determine the distance along an edge: in order, without overlap, parts
/// that nothing reached left out. Their frame is that of the edge's own half-edge, the smaller of
/// the twins. Lines go on into that half-edge's face where y < 0, into the twin's where y > 0, and
/// along the edge where y = 0. Valid as long as the call that hands it over.
/// @param half_edge either twin, in the mesh's numbering
/// @param windows overwritten
using FinalWindows = std::function<void(Index half_edge, std::vector<Window>& windows)>;

/// Does something with the final windows of a solve (Recording::read_windows).
using ReadWindows = std::function<void(const FinalWindows&)>;

}  // namespace geodesic
