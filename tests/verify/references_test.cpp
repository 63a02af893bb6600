#include "harness/verify/references.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace geodesic::harness {
namespace {

class RankReferences : public ::testing::Test {
 protected:
  std::vector<std::string> ranked(const Description& verified,
                                  const std::optional<std::string>& named = {}) {
    std::vector<std::string> names;
    for (const Description* solver : rank_references(verified, all_, named, times_)) {
      names.push_back(solver->name);
    }
    return names;
  }

  static Description described(const char* name, const char* family) {
    Description solver{};
    solver.name = name;
    solver.family = family;
    return solver;
  }
  RankReferences() {
    bound_.exactness = Exactness::upper_bound;
    oracle_.independent_oracle = true;
  }

  const RelativeTimes times_{{"a-sibling", 1}, {"b-slow", 10}, {"other", 2.5}};
  Description bound_ = described("bound", "edges");
  Description sibling_ = described("a-sibling", "CH");
  Description slow_ = described("b-slow", "FIFO");
  Description other_ = described("other", "MMP");
  Description unknown_ = described("a-unknown", "new");
  Description oracle_ = described("z-oracle", "CH");
  Description verified_ = described("verified", "CH");
  const std::vector<const Description*> all_{&sibling_, &slow_,   &bound_,   &unknown_,
                                             &other_,   &oracle_, &verified_};
};

TEST_F(RankReferences, OracleThenOtherFamiliesThenTheFaster) {
  EXPECT_EQ(ranked(verified_),
            (std::vector<std::string>{"z-oracle", "other", "b-slow", "a-unknown", "a-sibling"}));
}

TEST_F(RankReferences, TheNamedOneComesFirst) {
  EXPECT_EQ(ranked(verified_, "a-sibling").front(), "a-sibling");
}

TEST_F(RankReferences, OneThatRunsOnlyByNameVerifiesOnlyByName) {
  other_.by_name_only = true;
  EXPECT_EQ(std::ranges::count(ranked(verified_), "other"), 0);
  EXPECT_EQ(ranked(verified_, "other").front(), "other");
}

TEST_F(RankReferences, AnOracleThatRunsOnlyByNameVerifiesAlways) {
  oracle_.by_name_only = true;
  EXPECT_EQ(ranked(verified_).front(), "z-oracle");
}

TEST_F(RankReferences, NobodyVerifiesItself) {
  EXPECT_EQ(ranked(oracle_, "z-oracle").front(), "other");
}

TEST_F(RankReferences, UpperBoundsAreVerifiedByExactSolvers) {
  EXPECT_EQ(ranked(bound_).front(), "z-oracle");
  EXPECT_EQ(choose_upper_bound(all_), &bound_);
  EXPECT_EQ(choose_upper_bound({&other_}), nullptr);
}

}  // namespace
}  // namespace geodesic::harness
