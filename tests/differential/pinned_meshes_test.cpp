// Small meshes that a solver was once wrong on, found at random and repaired, stay right.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/corpus/solvers.h"
#include "harness/verify/property.h"
#include "meshes/mesh_file.h"

namespace geodesic::differential {
namespace {

/// Found and shrunk by `differential`; the files have the numbers of its meshes, of seed 1 unless
/// they say another.
struct Pin {
  const char* mesh;  ///< in meshes/
  Index source;
  const char* broke;  ///< solvers, with their largest relative error before the repair
};

const std::vector<Pin> kPins = {
    // A source next to edges thousands of times as long as its distances: what rounding of
    // coordinates decides was a reason to drop a window.
    {"mesh-2598", 0, "edge-based, edge-based-bucket: 5e-7"},
    {"mesh-3872", 0, "edge-based and its variants: 4e-8"},
    {"mesh-4561", 17, "edge-based and its variants: 2e-4"},
    {"mesh-4569", 8, "edge-based: 0.08"},
    {"mesh-5004", 4, "edge-based and its variants: 0.15"},
    {"mesh-7289", 6, "edge-based and its variants: 6e-6"},
    // A collapsed edge beside a flat face: a source and an apex that both lie on an edge's line saw
    // each other through it.
    {"mesh-7257", 7, "edge-based and its variants: 0.55"},
    // An edge a billionth as long as those beside it: its direction was no unit vector.
    {"mesh-705", 0, "a lazy variant: 0.07, all but edge-based and edge-based-bucket: 1e-11"},
    {"mesh-705", 17, "template: 8e-12, all but the edge-based: 6e-12"},
    {"mesh-705-again", 10, "template: 8e-10"},
    {"mesh-6969", 10, "template: 2e-11"},
    {"mesh-9808", 13, "template: 4e-10"},
    {"mesh-8341", 2, "all: 2e-12"},
    {"mesh-8341", 12, "all but the edge-based: 2e-12"},
    // Two windows of one source, the later one shorter by less than rounding at an edge's far end.
    {"seed-2-mesh-6031", 3, "fwp-mmp: 1e-9"},
    // All vertices on a line but for rounding, which said of one that no path bends there.
    {"seed-7-mesh-4989", 5, "mmp and its variants: 0.07"},
};

std::ostream& operator<<(std::ostream& out, const Pin& pin) {
  return out << pin.mesh << " from " << pin.source << ": " << pin.broke;
}

class PinnedMesh : public ::testing::TestWithParam<Pin> {};

TEST_P(PinnedMesh, is_right_by_every_exact_solver_and_instruction_set) {
  const Pin& pin = GetParam();
  const std::string file = std::string(PINNED_MESHES) + "/" + pin.mesh + ".obj";
  const Mesh mesh(read_mesh_file(file).soup);
  const Query query = harness::from(pin.source);
  const auto expected = BruteForce(mesh).distances(query.sources);
  for (const Description* solver : registered_solvers()) {
    // An independent oracle is not ours to repair.
    if (solver->exactness != Exactness::exact || solver->independent_oracle) continue;
    if (!harness::unsupported(*solver, mesh).empty()) continue;
    for (const InstructionSet set : std::set{InstructionSet::plain, widest_instruction_set()}) {
      set_instruction_set(set);
      const auto made = make_solver(solver->name, mesh);
      if (made->instruction_set() != set) continue;  // has plain ones only
      const auto wrong =
          harness::check_distances(query, harness::solve_with(*made, mesh, query), expected);
      EXPECT_FALSE(wrong) << solver->name << ", " << name_of(set)
                          << " instructions: " << wrong->what;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, PinnedMesh, ::testing::ValuesIn(kPins), [](const auto& pinned) {
  std::string name =
      std::string(pinned.param.mesh) + "_from_" + std::to_string(pinned.param.source);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace geodesic::differential
