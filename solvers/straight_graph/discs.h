// Preparation of the saddle vertex graph: links from each vertex to its nearest ones.
//
// Ying, Wang, He 2013. A vertex is linked to those of the nearest vertices to which a shortest path
// is a straight line. A search goes on from a vertex into all of its links.
#pragma once

#include "solvers/core/mesh.h"
#include "solvers/straight_graph/graph.h"
#include "solvers/straight_graph/line.h"

namespace geodesic::straight_graph {

/// Builds the graph of a mesh. It is the same to the last bit with any number of threads.
/// @param size number of nearest vertices, at least 1
/// @param threads at least 1
Graph build_disc_graph(const Mesh& mesh, Index size, unsigned threads);

/// @return what makes the links of that graph again
FollowLinks follow_links_of_disc(const Mesh& mesh, Index size);

}  // namespace geodesic::straight_graph
