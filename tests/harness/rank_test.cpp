// Rankings of times that were never measured: order, means, what is not resolved, what failed.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/rank/report.h"
#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kPairs = 9;

Json ok_row(const std::string& solver, double windows) {
  return {{"solver", solver},
          {"outcome", outcome::kOk},
          {"window_propagations", windows},
          {"solver_peak_bytes", 1000000},
          {"max_relative_error", 1e-15}};
}

// The candidate "new" takes `ratio` of each rival's 10 ms, in pairs that spread by `spread` around
// it, and twice as many windows as any rival.
MeasuredMesh mesh_of(const std::string& name,
                     const std::vector<std::pair<std::string, double>>& rivals,
                     double spread = 0.01, std::size_t pairs = kPairs) {
  MeasuredSource source{.source = 0};
  source.rows.push_back(ok_row("new", 2000));
  for (const auto& [rival, ratio] : rivals) {
    source.rows.push_back(ok_row(rival, 1000));
    PairedTimes times{.rival = rival};
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      const double off = spread * (static_cast<double>(pair) / static_cast<double>(pairs / 2) - 1);
      times.candidate_ms.push_back(10 * ratio * (1 + off));
      times.rival_ms.push_back(10);
    }
    source.pairs.push_back(times);
  }
  return {.mesh = name, .vertices = 100, .sources = {source}};
}

void fail(MeasuredMesh& mesh, const std::string& solver, const char* outcome) {
  MeasuredSource& source = mesh.sources.front();
  for (Json& row : source.rows) {
    if (row.at("solver") == solver)
      row = error_row(solver, mesh.mesh, 0, outcome, "vertex 7 is off");
  }
  std::erase_if(source.pairs,
                [&](const PairedTimes& pairs) { return solver == "new" || pairs.rival == solver; });
}

std::vector<std::string> order(const Ranking& ranking) {
  std::vector<std::string> names;
  for (const Standing& standing : ranking.standings) names.push_back(standing.solver);
  return names;
}

const Standing& standing_of(const Ranking& ranking, const std::string& solver) {
  return *std::find_if(ranking.standings.begin(), ranking.standings.end(),
                       [&](const Standing& standing) { return standing.solver == solver; });
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is missing in: " << text;
  }
}

bool has_remark(const Ranking& ranking, const std::string& words) {
  return std::any_of(ranking.remarks.begin(), ranking.remarks.end(),
                     [&](const auto& remark) { return remark.find(words) != std::string::npos; });
}

TEST(Rank, OrdersByGeometricMeansOfPairedRatios) {
  const Measurements measured{.candidate = "new",
                              .rivals = {"slow", "fast"},
                              .meshes = {mesh_of("cube", {{"slow", 0.5}, {"fast", 4}}),
                                         mesh_of("knot", {{"slow", 0.125}, {"fast", 1}})}};
  const Ranking ranking = rank(measured);
  EXPECT_EQ(order(ranking), (std::vector<std::string>{"fast", "new", "slow"}));
  EXPECT_NEAR(standing_of(ranking, "slow").time->ratio.value, 0.25, 1e-12);
  EXPECT_NEAR(standing_of(ranking, "fast").time->ratio.value, 2, 1e-12);
  EXPECT_TRUE(standing_of(ranking, "fast").time->resolved());
  EXPECT_NEAR(*standing_of(ranking, "slow").windows, 2, 1e-12);
  EXPECT_NEAR(*standing_of(ranking, "slow").memory, 1, 1e-12);
  EXPECT_FALSE(standing_of(ranking, "new").time.has_value());
  expect_words(verdict(ranking, measured),
               {"new takes 2.000 (", "of fast's time over 2 meshes, 0.250 (", "of slow's.",
                "right on 2 of 2 meshes", "1.0e-15"});
}

// A drift of the machine that slows both sides of a pair is no difference.
TEST(Rank, TakesRatiosWithinPairs) {
  Measurements measured{
      .candidate = "new", .rivals = {"a"}, .meshes = {mesh_of("cube", {{"a", 0.9}}, 0)}};
  PairedTimes& pairs = measured.meshes.front().sources.front().pairs.front();
  for (std::size_t pair = 0; pair < kPairs; ++pair) {
    const double drift = 1 + static_cast<double>(pair);
    pairs.candidate_ms[pair] *= drift;
    pairs.rival_ms[pair] *= drift;
  }
  const Ranking ranking = rank(measured);
  const TimeRatio time = *standing_of(ranking, "a").time;
  EXPECT_NEAR(time.ratio.low, 0.9, 1e-12);
  EXPECT_NEAR(time.ratio.high, 0.9, 1e-12);
  EXPECT_TRUE(time.resolved());
}

TEST(Rank, ADifferenceThatPairsDoNotResolveHasNoNumber) {
  Measurements measured{
      .candidate = "new", .rivals = {"a"}, .meshes = {mesh_of("cube", {{"a", 1.01}}, 0.1)}};
  Ranking ranking = rank(measured);
  EXPECT_FALSE(standing_of(ranking, "a").time->resolved());
  expect_words(as_markdown(ranking, measured), {"takes ~ (0.", "| ~ | "});
  EXPECT_TRUE(has_remark(ranking, "one mesh says nothing of others"));

  measured.meshes = {mesh_of("cube", {{"a", 0.5}}, 0.01, 5)};
  ranking = rank(measured);
  EXPECT_FALSE(standing_of(ranking, "a").time->resolved())
      << "5 pairs of a coin are alike too often";
  EXPECT_TRUE(has_remark(ranking, "fewer than 6 pairs resolve nothing"));
}

TEST(Rank, SourcesOfAMeshAreOneSample) {
  MeasuredMesh mesh = mesh_of("cube", {{"a", 0.5}}, 0.01, 3);
  mesh.sources.push_back(mesh.sources.front());
  const Ranking ranking = rank({.candidate = "new", .rivals = {"a"}, .meshes = {mesh}});
  EXPECT_EQ(standing_of(ranking, "a").time->pairs, 6u);
  EXPECT_TRUE(standing_of(ranking, "a").time->resolved());
}

TEST(Rank, ASolverThatCannotDoAMeshIsLeftOutOfItsMeanAndARemarkSaysSo) {
  Measurements measured{.candidate = "new",
                        .rivals = {"a", "b"},
                        .meshes = {mesh_of("cube", {{"a", 0.5}, {"b", 0.5}}),
                                   mesh_of("knot", {{"a", 0.1}, {"b", 0.5}})}};
  fail(measured.meshes[1], "a", outcome::kUnsupported);
  const Ranking ranking = rank(measured);
  EXPECT_NEAR(standing_of(ranking, "a").time->ratio.value, 0.5, 1e-12);
  EXPECT_EQ(standing_of(ranking, "a").meshes.size(), 1u);
  EXPECT_EQ(standing_of(ranking, "a").right, 1u);
  EXPECT_TRUE(has_remark(ranking, "a has no time on knot: unsupported"));
  EXPECT_TRUE(has_remark(ranking, "against a are over 1 of 2 meshes"));
  EXPECT_FALSE(has_remark(ranking, "against b"));
  expect_words(as_markdown(ranking, measured),
               {"| a | unsupported |", "of a's time over 1 mesh,", "of b's over 2 meshes"});
}

TEST(Rank, AWrongAnswerHasNoTimeAndIsSaidFirst) {
  Measurements measured{.candidate = "new",
                        .rivals = {"a"},
                        .meshes = {mesh_of("cube", {{"a", 0.5}}), mesh_of("knot", {{"a", 0.5}})}};
  fail(measured.meshes[0], "new", outcome::kWrongAnswer);
  Ranking ranking = rank(measured);
  EXPECT_EQ(standing_of(ranking, "a").meshes.size(), 1u);
  EXPECT_EQ(verdict(ranking, measured).find("WRONG ANSWERS of new"), 0u);
  expect_words(verdict(ranking, measured), {"right on 1 of 2 meshes"});
  EXPECT_TRUE(has_remark(ranking, "new has no time on cube: wrong answer: vertex 7 is off"));

  fail(measured.meshes[1], "new", outcome::kCrashed);
  ranking = rank(measured);
  EXPECT_EQ(order(ranking).size(), 2u);
  EXPECT_FALSE(standing_of(ranking, "a").time.has_value());
  expect_words(verdict(ranking, measured), {"could be timed against none", "right on 0 of 2"});
  EXPECT_TRUE(to_json(ranking, measured).at("standings")[0].at("time").is_null());
}

TEST(Rank, ASolverWithoutWindowsHasNoRatioOfThem) {
  MeasuredMesh mesh = mesh_of("cube", {{"a", 0.5}});
  mesh.sources.front().rows[1].erase("window_propagations");
  const Ranking ranking = rank({.candidate = "new", .rivals = {"a"}, .meshes = {mesh}});
  EXPECT_FALSE(standing_of(ranking, "a").windows.has_value());
  EXPECT_TRUE(standing_of(ranking, "a").memory.has_value());
}

TEST(Rank, WhatIsNotMeasuredYetIsSaid) {
  const Ranking ranking = rank({.candidate = "new",
                                .rivals = {"a"},
                                .meshes = {mesh_of("cube", {{"a", 0.5}})},
                                .unfinished = {"knot", "torus"}});
  EXPECT_TRUE(has_remark(ranking, "not measured yet: knot, torus"));
}

TEST(Rank, LatexHasBothTablesAndTheFigure) {
  const Measurements measured{
      .candidate = "new", .rivals = {"a"}, .meshes = {mesh_of("tiny_mesh", {{"a", 0.5}})}};
  expect_words(as_latex(rank(measured), measured),
               {"\\toprule", "tiny\\_mesh & 100 & 0.500 (0.4", "\\includegraphics{rank.pdf}"});
}

}  // namespace
}  // namespace geodesic::harness
