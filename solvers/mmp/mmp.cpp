// `mmp` and `fwp-mmp`: the same propagation of windows in two orders.
#include "solvers/mmp/mmp.h"

namespace geodesic::mmp {
namespace {

const RegisterSolver<Mmp<ByDistance>> mmp{{
    .name = "mmp",
    .family = "MMP",
    .paper = "Mitchell, Mount, Papadimitriou 1987; Surazhsky et al. 2005; Liu 2013",
    .data_structure = "priority queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .final_windows = true,
    .relative_time = 12,
    .abilities = {.non_manifold_edges = true, .surface_sources = true, .paths = true},
}};

const RegisterSolver<Mmp<ByBucket>> fwp_mmp{{
    .name = "fwp-mmp",
    .family = "MMP",
    .paper = "Xu, Wang, Liu, Liu, He 2015, Fast wavefront propagation; Liu 2013",
    .data_structure = "bucket and FIFO queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .final_windows = true,
    .relative_time = 10,
    .abilities = {.non_manifold_edges = true, .surface_sources = true, .paths = true},
}};

}  // namespace
}  // namespace geodesic::mmp
