// Edge-based wavefront propagation: the algorithm of the thesis (chapter 5), whose published
// successor is Qin, Han, Yu, Yu, Zhang 2016, "Fast and memory-efficient Voronoi diagram
// construction and exact geodesics by vertex-oriented triangle propagation" (VTP).
//
// The wavefront is a set of half-edges with lists of windows. Vertices wait in buckets by distance.
// When one is popped, the faces around it are entered: every list on their edges is propagated
// across its face as a whole, trimmed by Strategy I (trim.h) and divided by Strategy II (split.h).
// Windows that land on an edge whose next face has already been entered go on at once, through a
// FIFO; all others wait. Any order is correct, since only beaten lines are ever dropped; this one
// keeps late arrivals rare.
//
// The order of crossings and the end of a solve: wavefront.h; several threads:
// parallel/regional_wavefront.h. The crossing of a face: list_crossing.h. Its steps over whole
// lists (kernels.h) are compiled for several instruction sets; constructing a solver selects one
// (core/instruction_set.h). All of them give the same bits.
#include "solvers/edge_based/edge_based.h"

namespace geodesic::edge_based {

namespace {

const RegisterSolver<EdgeBased<ByDistance>> exact{{
    .name = "edge-based",
    .family = "edge-based",
    .paper = "thesis chapter 5; Qin, Han, Yu, Yu, Zhang 2016",
    .abilities = {.non_manifold_edges = true, .surface_sources = true, .paths = true},
    .parameters = {integer_parameter("threads", 1, 1, 256, "that work on one query"),
                   integer_parameter("region-size", 0, 0, 1 << 20,
                                     "vertices of a region of the mesh, with several threads; 0: "
                                     "a 32nd of them, from 1024 to 4096")},
}};

}  // namespace
}  // namespace geodesic::edge_based
