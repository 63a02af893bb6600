// `mmp` and `fwp-mmp`: the same propagation of windows in two orders.
#include "solvers/mmp/mmp.h"

namespace geodesic::mmp {
namespace {

const RegisterSolver<Mmp<ByDistance>> mmp{{
    .name = "mmp",
    .family = "MMP",
    .paper = "Mitchell, Mount, Papadimitriou 1987; Surazhsky et al. 2005; Liu 2013",
    .final_windows = true,
    .abilities = {.non_manifold_edges = true, .surface_sources = true, .paths = true},
}};

const RegisterSolver<Mmp<ByBucket>> fwp_mmp{{
    .name = "fwp-mmp",
    .family = "MMP",
    .paper = "Xu, Wang, Liu, Liu, He 2015, Fast wavefront propagation; Liu 2013",
    .final_windows = true,
    .abilities = {.non_manifold_edges = true, .surface_sources = true, .paths = true},
}};

}  // namespace
}  // namespace geodesic::mmp
