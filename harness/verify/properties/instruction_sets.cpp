// Instruction sets change how fast a solver is and nothing else.
#include "solvers/core/instruction_set.h"

#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

// The process's choice, put back afterwards.
class Choice {
 public:
  Choice() = default;
  ~Choice() { set_instruction_set(before_); }
  Choice(const Choice&) = delete;
  Choice& operator=(const Choice&) = delete;

 private:
  InstructionSet before_ = instruction_set();
};

std::unique_ptr<Solver> prepare_for(InstructionSet set, const Trial& trial) {
  set_instruction_set(set);
  return trial.prepare();
}

// Distances and counters by the plain path and by the widest one.
Finding same_bits_and_counters(const Trial& trial) {
  const Choice choice;
  const Mesh& mesh = trial.mesh();
  const Query& query = trial.query();
  const auto plain = prepare_for(InstructionSet::plain, trial);
  const auto wide = prepare_for(widest_instruction_set(), trial);
  if (wide->instruction_set() == plain->instruction_set()) return {};  // there is one path
  if (auto wrong = identical(query, ask(*wide, mesh, query), ask(*plain, mesh, query)))
    return in("by the widest instructions, beside plain ones", wrong);
  Recording by_plain, by_wide;
  set_instruction_set(InstructionSet::plain);  // must not matter any more
  const auto recorded = ask(*wide, mesh, query, &by_wide);
  if (auto wrong = identical(query, recorded, ask(*plain, mesh, query, &by_plain)))
    return in("recorded, by the widest instructions", wrong);
  return require(by_wide == by_plain, "by the widest instructions a counter changed");
}

Finding never_wider_than_chosen(const Trial& trial) {
  const Choice choice;
  return require(
      prepare_for(InstructionSet::plain, trial)->instruction_set() == InstructionSet::plain,
      "a solver that was constructed for plain instructions uses others");
}

std::vector<Case> lists_of_many_windows() {
  return {{"terrain", rough_terrain(71, 50, 50, 0.1), {from(7)}},
          {"sphere", rough_sphere(72, 4, 0.02), {from(7)}},
          {"torus", rough_torus(73, 60, 30, 0.5), {from(7)}}};
}

std::vector<Case> holes_and_missing_faces() {
  std::vector<Case> cases;
  for (std::uint64_t seed = 80; seed < 90; ++seed) {
    const auto terrain = rough_terrain(seed, 12, 12, 0.5);
    const std::string number = std::to_string(seed);
    cases.push_back({"holes " + number, with_holes(terrain, seed, 4), {from(0)}});
    cases.push_back({"gaps " + number, with_missing_faces(terrain, seed, 9), {from(0)}});
  }
  return cases;
}

}  // namespace

std::vector<Property> instruction_set_properties() {
  return {
      {"instruction-sets-are-never-wider-than-the-one-chosen",
       "a solver that is constructed for plain instructions uses no others",
       {},
       [] {
         return std::vector<Case>{{"sphere", rough_sphere(74, 1, 0.2), {from(0)}}};
       },
       never_wider_than_chosen},
      {"instruction-sets-give-the-same-bits-and-counters",
       "vector instructions change neither a bit of a distance nor a counter",
       {},
       [] { return random_mesh_cases({from(4)}); },
       same_bits_and_counters},
      {"instruction-sets-give-the-same-bits-and-counters-with-holes-and-missing-faces",
       "vector instructions change neither a bit nor a counter on ragged surfaces",
       {},
       holes_and_missing_faces,
       same_bits_and_counters},
      {"instruction-sets-give-the-same-bits-and-counters-on-lists-of-many-windows",
       "vector instructions change neither a bit nor a counter where edges have many windows",
       {},
       lists_of_many_windows,
       same_bits_and_counters},
  };
}

}  // namespace geodesic::conformance
