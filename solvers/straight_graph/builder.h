// Preparation: the links of all vertices, found by unfolding from each of them alone.
#pragma once

#include "solvers/core/mesh.h"
#include "solvers/straight_graph/graph.h"
#include "solvers/straight_graph/line.h"

namespace geodesic::straight_graph {

/// How far from straight a path may go on, in angles of a wedge. Links that continue a straight
/// line are up to one such angle apart on either side; with less, rare vertices stay far too long.
inline constexpr double kSlack = 1.25;

/// Builds the graph of a mesh. It is the same to the last bit with any number of threads.
/// @param angle least angle of a wedge that is split, in radians (unfold.h)
/// @param threads at least 1
Graph build_graph(const Mesh& mesh, double angle, unsigned threads);

/// @return what makes the links of that graph again
FollowLinks follow_links_by_angle(const Mesh& mesh, double angle);

}  // namespace geodesic::straight_graph
