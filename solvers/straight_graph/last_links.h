// How the paths of a search arrive: the last links to vertices and targets.
#pragma once

#include <span>

#include "solvers/core/query.h"
#include "solvers/core/recording.h"

namespace geodesic::straight_graph {

/// Fills the last segments and targets of a recording of paths. The link to a vertex is found again
/// from its end: only wedges by which a line of its length may lead to its root are followed. A
/// target in a face sends out a fan of wedges, which meets vertices and sources.
/// @param angle the graph's
/// @param distances, roots of the search (Search::run)
void record_last_links(const Mesh& mesh, const InternalQuery& query, double angle,
                       std::span<const double> distances, std::span<const Index> roots,
                       Recording& recording);

}  // namespace geodesic::straight_graph
