#include "harness/corpus/suite.h"

#include "tests/harness/expect_error.h"
#include "tests/harness/temporary_folder.h"

namespace geodesic::harness {
namespace {

using SuiteFile = TemporaryFolder;

TEST_F(SuiteFile, SetsEveryKey) {
  const Suite suite = read_suite(write("suite.json", R"({
    "solvers": ["a", "b"], "corpus": "real", "meshes": ["m"], "sources": 5, "repetitions": 7,
    "source_sets": ["random:8", "boundary"],
    "other_queries": 4, "path_targets": 7, "seed": 18446744073709551615, "min_time": 0.25, "reference": "a", "vectors": "plain"})"));
  EXPECT_EQ(suite.solvers, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(suite.corpus, "real");
  EXPECT_EQ(suite.meshes, std::vector<std::string>{"m"});
  EXPECT_EQ(suite.sources, 5);
  EXPECT_EQ(suite.source_sets, (std::vector<std::string>{"random:8", "boundary"}));
  EXPECT_EQ(suite.repetitions, 7);
  EXPECT_EQ(suite.seed, 18446744073709551615u);
  EXPECT_EQ(suite.other_queries, 4);
  EXPECT_EQ(suite.path_targets, 7);
  EXPECT_EQ(suite.min_time, 0.25);
  EXPECT_EQ(suite.reference, "a");
  EXPECT_EQ(suite.vectors, "plain");
}

TEST_F(SuiteFile, LeavesOutWhatItDoesNotChange) {
  const Suite suite = read_suite(write("suite.json", "{}"));
  EXPECT_TRUE(suite.solvers.empty());
  EXPECT_EQ(suite.corpus, "quick");
  EXPECT_FALSE(suite.reference);
}

TEST_F(SuiteFile, RefusesUnknownKeysAndListsTheKnownOnes) {
  const auto file = write("suite.json", R"({"repetition": 3})");
  expect_error([&] { read_suite(file); },
               {"suite.json", "'repetition'", "did you mean 'repetitions'",
                "min_time, other_queries, path_targets, reference"});
}

TEST_F(SuiteFile, RefusesValuesOutOfRange) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"({"sources": 0})", "at least one source"},
      {R"({"source_sets": ["random"]})", "no set of sources: random"},
      {R"({"source_sets": ["boundary", "boundary"]})", "two sets are called 'boundary'"},
      {R"({"sources": 2.5})", "not a non-negative integer"},
      {R"({"sources": -1})", "not a non-negative integer"},
      {R"({"sources": 4294967297})", "too large"},
      {R"({"repetitions": 0})", "at least one repetition"},
      {R"({"min_time": 0})", "positive number of seconds"},
      {R"({"solvers": "mmp"})", "\"solvers\": \"mmp\""},
      {R"({"reference": null})", "\"reference\": null"},
      {R"({"corpus": "../../a"})", "invalid corpus name '../../a'"},
      {R"({"vectors": "wide"})", "no kind of vectors named 'wide'"},
      {R"([])", "JSON object"},
      {R"({"sources": )", "not valid JSON"},
  };
  for (const auto& [text, message] : cases) {
    SCOPED_TRACE(text);
    const auto file = write("suite.json", text);
    expect_error([&] { read_suite(file); }, {"suite.json", message});
  }
}

TEST_F(SuiteFile, MissingIsAnErrorThatNamesIt) {
  expect_error([&] { read_suite(folder_ / "none.json"); }, {"none.json", "No such file"});
}

TEST(DefaultSuite, IsValid) { EXPECT_EQ(read_suite(default_suite()).corpus, "quick"); }

}  // namespace
}  // namespace geodesic::harness
