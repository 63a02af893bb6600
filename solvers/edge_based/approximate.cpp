// `edge-based-approximate`.
#include "solvers/edge_based/approximate.h"

namespace geodesic::edge_based {
namespace {

const RegisterSolver<Approximate> approximate{{
    .name = "edge-based-approximate",
    .family = "edge-based",
    .paper = "thesis section 6.2.2",
    .exactness = Exactness::bounded,
    .error_bound = [](const Description& solver) { return solver.real("tolerance"); },
    .by_name_only = true,
    .abilities = {.non_manifold_edges = true, .surface_sources = true},
    .remarks = "tolerance=0 gives the distances of edge-based",
    .parameters = {real_parameter("tolerance", 0.01, 0, 1, "the largest relative error")},
}};

}  // namespace
}  // namespace geodesic::edge_based
