#include "harness/results/text_table.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

TEST(TextTable, LatexHasRulesAndNoCharacterThatMeansSomethingElse) {
  EXPECT_EQ(as_latex({{"a_b", "50%"}, {"~", "\\x"}}),
            "\\begin{tabular}{lr}\n\\toprule\na\\_b & 50\\% \\\\\n\\midrule\n"
            "$\\sim$ & \\textbackslash{}x \\\\\n\\bottomrule\n\\end{tabular}\n");
}

}  // namespace
}  // namespace geodesic::harness
