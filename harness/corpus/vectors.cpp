#include "harness/corpus/vectors.h"

#include "harness/base/error.h"

namespace geodesic::harness {

InstructionSet instruction_set_named(const std::string& word) {
  if (word == kAutoVectors) return widest_instruction_set();
  std::vector<std::string> known{kAutoVectors};
  for (const InstructionSet set : {InstructionSet::plain, InstructionSet::avx2}) {
    known.emplace_back(name_of(set));
    if (word != name_of(set)) continue;
    const std::string why = why_unavailable(set);
    if (!why.empty()) throw HarnessError("--vectors " + word + ": " + why);
    return set;
  }
  throw HarnessError(unknown_name("kind of vectors", word, known));
}

}  // namespace geodesic::harness
