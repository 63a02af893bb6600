// `ch`, `ich` and `fwp-ch`: one propagation of windows in three orders; only `ch` has no filter.
#include "solvers/chen_han/chen_han.h"

namespace geodesic::chen_han {
namespace {

const RegisterSolver<ChenHan<Ch>> ch{{
    .name = "ch",
    .family = "CH",
    .paper = "Chen, Han 1990, Shortest paths on a polyhedron",
    .abilities =
        {.degenerate_faces = false, .surface_sources = true, .paths = true, .max_vertices = 1200},
    .remarks = "small meshes only: nearly all of its windows are useless",
}};

const RegisterSolver<ChenHan<Ich>> ich{{
    .name = "ich",
    .family = "CH",
    .paper = "Xin, Wang 2009, Improving Chen and Han's algorithm",
    .abilities = {.surface_sources = true, .paths = true},
}};

const RegisterSolver<ChenHan<FwpCh>> fwp_ch{{
    .name = "fwp-ch",
    .family = "CH",
    .paper = "Xu, Wang, Liu, Liu, He 2015, Fast wavefront propagation",
    .abilities = {.surface_sources = true, .paths = true},
}};

}  // namespace
}  // namespace geodesic::chen_han
