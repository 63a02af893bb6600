#include "harness/verify/references.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

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

class ChooseReference : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const Description* solver : registered_solvers()) {
      if (solver->independent_oracle) oracle_ = solver->name;
    }
    if (oracle_.empty()) GTEST_SKIP() << "no independent oracle is registered";
  }

  // A candidate that is not in `answers_` fails.
  ReferenceDistances chosen(const std::vector<std::string>& candidates) {
    asked_.clear();
    return choose_reference(candidates, [&](const std::string& name) -> std::vector<double> {
      asked_.push_back(name);
      const auto answer = answers_.find(name);
      if (answer == answers_.end()) throw NoReference(name + " crashed");
      return {0, answer->second};
    });
  }

  std::string oracle_;
  std::map<std::string, double> answers_;
  std::vector<std::string> asked_;
};

TEST_F(ChooseReference, TakesTheFirstThatIsNoOracleAtItsWord) {
  answers_ = {{"b", 1}, {"c", 2}};
  EXPECT_EQ(chosen({"a", "b", "c"}).by, "b");
  EXPECT_EQ(asked_, (std::vector<std::string>{"a", "b"}));
}

TEST_F(ChooseReference, TakesAnOracleThatTheNextOneConfirms) {
  answers_ = {{oracle_, 1}, {"b", 1 + 1e-14}, {"c", 2}};
  const ReferenceDistances reference = chosen({oracle_, "a", "b", "c"});
  EXPECT_EQ(reference.by, oracle_);
  EXPECT_EQ(reference.remark, "");
  EXPECT_EQ(asked_, (std::vector<std::string>{oracle_, "a", "b"}));
}

TEST_F(ChooseReference, LetsAThirdDecideWhereTheNextOneContradictsAnOracle) {
  answers_ = {{oracle_, 1 + 1e-9}, {"a", 1}, {"b", 1}};
  const ReferenceDistances reference = chosen({oracle_, "a", "b", "c"});
  EXPECT_EQ(reference.by, "b");
  EXPECT_EQ(reference.values[1], 1);
  EXPECT_EQ(reference.remark,
            oracle_ + " differs from b, the reference (largest relative error 1e-09)");
  answers_["b"] = answers_[oracle_];
  EXPECT_EQ(chosen({oracle_, "a", "b", "c"}).by, oracle_);
}

TEST_F(ChooseReference, LetsKnownDistancesDecideAlone) {
  answers_ = {{oracle_, 1 + 1e-9}, {kClosedForm, 1}, {"a", 1 + 1e-9}};
  EXPECT_EQ(chosen({oracle_, kClosedForm, "a"}).by, kClosedForm);
}

TEST_F(ChooseReference, TakesTheOneThatIsLeft) {
  answers_ = {{oracle_, 1}};
  EXPECT_EQ(chosen({"a", oracle_, "b"}).by, oracle_);
  answers_["b"] = 2;
  EXPECT_EQ(chosen({oracle_, "b"}).by, "b");
}

TEST_F(ChooseReference, SaysWhyThereIsNone) {
  try {
    chosen({"a", oracle_});
    FAIL() << "nothing was thrown";
  } catch (const NoReference& none) {
    EXPECT_EQ(std::string(none.what()),
              "no other exact solver gave distances (a crashed; " + oracle_ + " crashed)");
  }
}

}  // namespace
}  // namespace geodesic::harness
