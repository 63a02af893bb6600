// How the paths of a search arrive: the last links to vertices and targets.
#pragma once

#include <span>

#include "solvers/core/query.h"
#include "solvers/core/recording.h"
#include "solvers/straight_graph/line.h"

namespace geodesic::straight_graph {

/// Fills the last segments and targets of a recording of paths. The links of a root are made again.
/// A target in a face sends out a fan of wedges, which meets vertices and sources.
/// @param angle the graph's
/// @param distances, roots of the search (Search::run)
/// @param follow_links of the graph
void record_last_links(const Mesh& mesh, const InternalQuery& query, double angle,
                       std::span<const double> distances, std::span<const Index> roots,
                       const FollowLinks& follow_links, Recording& recording);

}  // namespace geodesic::straight_graph
