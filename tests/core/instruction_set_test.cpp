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
  const std::string why = why_unavailable(InstructionSet::avx2);
  if (why.empty()) GTEST_SKIP() << "this processor and this build have all";
  EXPECT_THROW(set_instruction_set(InstructionSet::avx2), std::invalid_argument);
  EXPECT_NE(why.find("AVX2"), std::string::npos);
}

}  // namespace
}  // namespace geodesic
