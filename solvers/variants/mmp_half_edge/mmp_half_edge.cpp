// `mmp-half-edge`: MMP with two lists of windows an edge, to measure what one list is worth.
#include "solvers/mmp/recorded.h"

namespace geodesic::mmp_half_edge {

/// Windows of the two sides of an edge are kept apart.
struct HalfEdge : mmp::ByDistance {
  using Layout = mmp::ListPerHalfEdge;
};

namespace {

const RegisterSolver<mmp::Mmp<HalfEdge>> registered{{
    .name = "mmp-half-edge",
    .family = "MMP",
    .paper = "Surazhsky et al. 2005, Fast exact and approximate geodesics on meshes",
    .abilities = {.surface_sources = true, .paths = true},
    .remarks = "windows of the two sides of an edge are not trimmed against each other",
}};

}  // namespace
}  // namespace geodesic::mmp_half_edge
