// Instruction sets change how fast a solver is and nothing else.
#include "solvers/core/instruction_set.h"

#include <stdexcept>

#include "tests/conformance/solver_test.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class InstructionSets : public SolverTest {
 protected:
  ~InstructionSets() override { set_instruction_set(widest_instruction_set()); }

  std::unique_ptr<Solver> prepare_for(InstructionSet set, const Mesh& mesh) const {
    set_instruction_set(set);
    return prepare(mesh);
  }

  /// Distances and counters by the plain path and by the widest one.
  void expect_same(const std::string& name, const TriangleSoup& soup, Index source) const {
    const Mesh mesh(soup);
    const auto plain = prepare_for(InstructionSet::plain, mesh);
    const auto wide = prepare_for(widest_instruction_set(), mesh);
    if (plain->instruction_set() == wide->instruction_set()) {
      GTEST_SKIP() << GetParam() << " has one path";
    }
    EXPECT_TRUE(identical(ask(*wide, mesh, from(source)), ask(*plain, mesh, from(source)))) << name;
    Recording by_plain, by_wide;
    set_instruction_set(InstructionSet::plain);  // must not matter any more
    const auto recorded = ask(*wide, mesh, from(source), &by_wide);
    EXPECT_TRUE(identical(recorded, ask(*plain, mesh, from(source), &by_plain))) << name;
    EXPECT_EQ(by_wide, by_plain) << name;
  }
};

TEST_P(InstructionSets, give_the_same_bits_and_counters) {
  for (const auto& [name, soup] : oracles::random_meshes()) expect_same(name, soup, 4);
}

TEST_P(InstructionSets, give_the_same_bits_and_counters_on_lists_of_many_windows) {
  NEEDS(abilities().max_vertices > 3000);
  expect_same("terrain", oracles::rough_terrain(71, 50, 50, 0.1), 7);
  expect_same("sphere", oracles::rough_sphere(72, 4, 0.02), 7);
  expect_same("torus", oracles::rough_torus(73, 60, 30, 0.5), 7);
}

TEST_P(InstructionSets, give_the_same_bits_and_counters_with_holes_and_missing_faces) {
  NEEDS(abilities().non_manifold_vertices);
  for (std::uint64_t seed = 80; seed < 90; ++seed) {
    const auto terrain = oracles::rough_terrain(seed, 12, 12, 0.5);
    expect_same("holes " + std::to_string(seed), oracles::with_holes(terrain, seed, 4), 0);
    expect_same("gaps " + std::to_string(seed), oracles::with_missing_faces(terrain, seed, 9), 0);
  }
}

TEST_P(InstructionSets, are_never_wider_than_the_one_chosen) {
  const Mesh mesh(oracles::rough_sphere(74, 1, 0.2));
  EXPECT_EQ(prepare_for(InstructionSet::plain, mesh)->instruction_set(), InstructionSet::plain);
}

FOR_EVERY_SOLVER(InstructionSets);

TEST(InstructionSet, is_the_widest_one_unless_another_is_chosen) {
  EXPECT_EQ(instruction_set(), widest_instruction_set());
  EXPECT_EQ(why_unavailable(widest_instruction_set()), "");
}

TEST(InstructionSet, that_is_not_there_is_refused_with_the_reason) {
  const std::string why = why_unavailable(InstructionSet::avx2);
  if (why.empty()) GTEST_SKIP() << "this processor and this build have all";
  EXPECT_THROW(set_instruction_set(InstructionSet::avx2), std::invalid_argument);
  EXPECT_NE(why.find("AVX2"), std::string::npos);
}

}  // namespace
}  // namespace geodesic::conformance
