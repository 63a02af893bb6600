// geodesic-bench rank, with sound solvers and with faulty ones.
#include <algorithm>

#include "tests/harness/program.h"
#include "tests/harness/whole_manifest.h"

namespace geodesic::harness {
namespace {

using nlohmann::json;

class RankTest : public ProgramTest {
 protected:
  Output rank(const Program& program, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "rank");
    arguments.insert(arguments.end(), {"--out", out_.string(), "--min-time", "0.0001", "--pairs",
                                       "3", "--no-figure"});
    return run(program, arguments);
  }
  json result() const { return read_json(out_ / "rank.json"); }
  json ranking() const { return result().at("ranking"); }

  const std::filesystem::path out_ = folder_ / "out";
};

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is missing in: " << text;
  }
}

TEST_F(RankTest, WritesWhatItPrintsAndEveryPair) {
  const Output ranked = rank(PROGRAM, {"--solver", exact_solver(), "--against", "dijkstra"});
  ASSERT_EQ(ranked.code, 0) << ranked.err;
  EXPECT_EQ(ranked.out, read(out_ / "rank.md"));
  expect_words(ranked.out, {"# " + exact_solver() + " against dijkstra", "## hill, 37 vertices",
                            "## tetrahedron, 4 vertices", "2 of 2"});
  expect_words(ranked.err, {"skipped absent"});
  expect_words(read(out_ / "rank.tex"), {"\\toprule", "tetrahedron"});
  const json pairs = ranking().at("pairs");
  ASSERT_EQ(pairs.size(), 2u);
  for (const json& pair : pairs) {
    EXPECT_EQ(pair.at("rival"), "dijkstra");
    EXPECT_EQ(pair.at("candidate_ms").size(), 3u);
    EXPECT_EQ(pair.at("rival_ms").size(), 3u);
  }
  EXPECT_EQ(ranking().at("unfinished"), json::array());
  const json benchmarks = result().at("benchmarks");
  for (const json& row : benchmarks) {
    EXPECT_EQ(row.at("outcome"), "ok");
    EXPECT_TRUE(row.contains("solver_peak_bytes"));
  }
  EXPECT_EQ(result().at("context").at("geodesic_bench").at("meshes").size(), 2u);
  EXPECT_FALSE(std::filesystem::exists(out_ / "pair.json"));
}

TEST_F(RankTest, AWrongAnswerHasNoTimeAndExitCode2) {
  for (const std::string solver : {"wrong", "forgetful", "disturbed"}) {
    std::filesystem::remove_all(out_);
    const Output ranked = rank(kFaultyProgram, {"--solver", solver, "--against", exact_solver(),
                                                "--meshes", "tetrahedron"});
    EXPECT_EQ(ranked.code, 2) << ranked.err;
    expect_words(ranked.out, {"WRONG ANSWERS of " + solver, "right on 0 of 1 mesh"});
    EXPECT_EQ(ranking().at("pairs"), json::array());
  }
}

TEST_F(RankTest, ARivalThatFailsTakesNothingFromTheOthers) {
  const Output ranked = rank(kFaultyProgram, {"--solver", exact_solver(), "--against",
                                              "crashing,tiny,dijkstra", "--meshes", "tetrahedron"});
  EXPECT_EQ(ranked.code, 1) << "crashed";
  expect_words(ranked.out, {"crashing has no time on tetrahedron: crashed",
                            "tiny has no time on "
                            "tetrahedron: unsupported",
                            "of dijkstra's time over 1 mesh"});
  EXPECT_EQ(ranking().at("pairs").size(), 1u);
  EXPECT_EQ(ranking().at("standings").size(), 4u);
}

TEST_F(RankTest, BadRequestsAreOneLineAndWriteNothing) {
  const auto refused = [&](std::vector<std::string> arguments, std::vector<std::string> words) {
    const Output output = rank(PROGRAM, std::move(arguments));
    EXPECT_EQ(output.code, 1) << output.err;
    EXPECT_EQ(std::count(output.err.begin(), output.err.end(), '\n'), 1) << output.err;
    expect_words(output.err, words);
    EXPECT_FALSE(std::filesystem::exists(out_));
  };
  const std::string solver = exact_solver();
  refused({"--against", solver}, {"--solver is required"});
  refused({"--solver", solver}, {"--against is required"});
  refused({"--solver", "dijkstr", "--against", solver}, {"did you mean 'dijkstra'"});
  refused({"--solver", solver, "--against", "dijkstr"}, {"did you mean 'dijkstra'"});
  refused({"--solver", solver, "--against", "dijkstra," + solver}, {"against itself", "--against"});
  refused({"--solver", solver, "--against", "dijkstra,dijkstra"}, {"'dijkstra' twice"});
  refused({"--solver", solver, "--against", "dijkstra", "--corpus", "quik"}, {"'quick'"});
  refused({"--solver", solver, "--against", "dijkstra", "--corpus", "missing"},
          {"nothing to run", "fetch.py absent"});
  refused({"--solver", solver, "--against", "dijkstra", "--sources", "0"}, {"at least one source"});
}

TEST_F(RankTest, PairsAreAtLeastOne) {
  const Output output = run(PROGRAM, {"rank", "--solver", exact_solver(), "--against", "dijkstra",
                                      "--pairs", "0", "--out", out_.string()});
  EXPECT_EQ(output.code, 1);
  expect_words(output.err, {"--pairs"});
}

TEST_F(RankTest, AnEmptyCorpusIsSaid) {
  const std::string solver = exact_solver();
  write("manifest.json", whole_manifest(R"({"corpora": {"quick": []}, "meshes": []})"));
  const Output output = rank(PROGRAM, {"--solver", solver, "--against", "dijkstra"});
  EXPECT_EQ(output.code, 1);
  expect_words(output.err, {"corpora: quick: must not be empty"});
}

TEST_F(RankTest, ResultsAreNeverWrittenOver) {
  std::filesystem::create_directories(out_ / "cells");
  const Output output = rank(PROGRAM, {"--solver", exact_solver(), "--against", "dijkstra"});
  EXPECT_EQ(output.code, 1);
  expect_words(output.err, {"holds a run already"});
}

}  // namespace
}  // namespace geodesic::harness
