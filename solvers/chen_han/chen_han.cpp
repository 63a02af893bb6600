// `ch`, `ich` and `fwp-ch`: one propagation of windows in three orders, filtered but for `ch`.
#include <stdexcept>

#include "solvers/chen_han/policies.h"
#include "solvers/chen_han/propagation.h"
#include "solvers/chen_han/recorded.h"
#include "solvers/registry.h"

namespace geodesic::chen_han {
namespace {

template <class Policy>
class ChenHan final : public Solver {
 public:
  ChenHan(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(checked(mesh, description)) {}

 private:
  static const Mesh& checked(const Mesh& mesh, const Description& description) {
    if (mesh.vertex_count() <= kMaxVertices) return mesh;
    throw std::invalid_argument(description.name + ": supports at most " +
                                std::to_string(kMaxVertices) + " vertices");
  }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return propagation_.run(query, distances);
    solve_recorded<Policy>(mesh(), query, distances, *recording);
  }

  Propagation<Policy, NoRecorder> propagation_;
};

const RegisterSolver<ChenHan<Ch>> ch{{
    .name = "ch",
    .family = "CH",
    .paper = "Chen, Han 1990, Shortest paths on a polyhedron",
    .data_structure = "FIFO queue",
    .time_complexity = "O(n^2)",
    .space_complexity = "O(n)",
    .propagation = "window",
    .abilities = {.degenerate_faces = false, .max_vertices = 1200},
    .remarks = "small meshes only: nearly all of its windows are useless",
}};

const RegisterSolver<ChenHan<Ich>> ich{{
    .name = "ich",
    .family = "CH",
    .paper = "Xin, Wang 2009, Improving Chen and Han's algorithm",
    .data_structure = "priority queue",
    .time_complexity = "O(n^2 log n)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .relative_time = 6,
}};

const RegisterSolver<ChenHan<FwpCh>> fwp_ch{{
    .name = "fwp-ch",
    .family = "CH",
    .paper = "Xu, Wang, Liu, Liu, He 2015, Fast wavefront propagation",
    .data_structure = "bucket and FIFO queue",
    .time_complexity = "O(n^2)",
    .space_complexity = "O(n^2)",
    .propagation = "window",
    .relative_time = 5,
}};

}  // namespace
}  // namespace geodesic::chen_han
