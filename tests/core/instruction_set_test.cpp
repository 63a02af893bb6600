#include "solvers/core/instruction_set.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace geodesic {
namespace {

TEST(InstructionSet, is_the_widest_one_unless_another_is_chosen) {
  EXPECT_EQ(instruction_set(), widest_instruction_set());
  EXPECT_EQ(why_unavailable(widest_instruction_set()), "");
}

TEST(InstructionSet, that_is_not_there_is_refused_with_the_reason) {
  int refused = 0;
  for (const InstructionSet set : kInstructionSets) {
    const std::string why = why_unavailable(set);
    if (why.empty()) continue;
    ++refused;
    EXPECT_THROW(set_instruction_set(set), std::invalid_argument);
    EXPECT_NE(why.find(set == InstructionSet::avx2 ? "AVX2" : "AVX-512"), std::string::npos);
  }
  if (refused == 0) GTEST_SKIP() << "this processor and this build have all";
}

}  // namespace
}  // namespace geodesic
