// Comparing two runs: what is resolved, what fails, what cannot be compared.
#include "harness/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/compare/limits.h"
#include "harness/compare/report.h"
#include "harness/exports/exports.h"
#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

using Times = std::vector<double>;

Json row(const std::string& solver, double cpu_ms) {
  return {{"run_name", solver + "/cube/src:0"},
          {"solver", solver},
          {"mesh", "cube"},
          {"outcome", "ok"},
          {"cpu_time", cpu_ms},
          {"window_propagations", 1000},
          {"solver_peak_bytes", 1000000}};
}

// A file with cells of these solvers on one mesh.
ResultFile file_of(const std::vector<std::pair<std::string, Times>>& cells) {
  ResultFile file{.file = "some.json",
                  .context = {{"geodesic_bench",
                               {{"corpus", "quick"},
                                {"processor", "one"},
                                {"compiler", "GNU"},
                                {"compiler_flags", "-O3"},
                                {"build_type", "Release"},
                                {"meshes", {{{"name", "cube"}, {"sha256", "00"}}}}}}},
                  .cells = {}};
  for (const auto& [solver, times] : cells) {
    CellResult cell{.name = solver + "/cube/src:0",
                    .solver = solver,
                    .mesh = "cube",
                    .outcome = "ok",
                    .message = "",
                    .rows = {}};
    for (const double time : times) cell.rows.push_back(row(solver, time));
    file.cells.push_back(cell);
  }
  return file;
}

const Times kBefore{10, 10.1, 10.2, 9.9, 10.3};
const Times kSlower{12, 12.1, 12.2, 11.9, 12.3};
const Times kAlike{10.05, 10.15, 9.8, 10.25, 10};

void set_number(ResultFile& file, const std::string& key, double value) {
  for (Json& row : file.cells.front().rows) row[key] = value;
}

void fail(CellResult& cell, const std::string& outcome) {
  cell.outcome = outcome;
  cell.message = "vertex 7 is off";
  cell.rows.resize(1);
}

std::size_t failures(const ResultFile& before, const ResultFile& after, const std::string& limit) {
  return exceeded(compare(before, after), parse_limits({limit})).size();
}

TEST(MannWhitney, AgreesWithTablesAndCountsArrangements) {
  EXPECT_DOUBLE_EQ(mann_whitney_p({1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}), 2.0 / 252);
  EXPECT_DOUBLE_EQ(mann_whitney_p({6, 7, 8}, {1, 2, 3}), 2.0 / 20);
  // {1, 2, 4} against {3, 5, 6}: U = 1 of 9; 1 and 1 arrangements have U = 0 and 1.
  EXPECT_DOUBLE_EQ(mann_whitney_p({1, 2, 4}, {3, 5, 6}), 2 * 2.0 / 20);
  EXPECT_DOUBLE_EQ(mann_whitney_p({1, 1, 1}, {1, 1, 1}), 1);
  EXPECT_DOUBLE_EQ(mann_whitney_p({}, {1}), 1);
}

// 101 values against as many are too many to count: R's wilcox.test(exact = FALSE) and scipy's
// mannwhitneyu(method="asymptotic") give the p-value below.
TEST(MannWhitney, TakesManyValuesForNormal) {
  Times a, b;
  for (int i = 0; i < 101; ++i) {
    a.push_back(2 * i);
    b.push_back(2 * i + 31);
  }
  EXPECT_NEAR(mann_whitney_p(a, b), 0.0005042725954040361, 1e-15);
  EXPECT_DOUBLE_EQ(mann_whitney_p(Times(100'000, 1), Times(100'000, 1)), 1);
}

TEST(GeometricMean, OfTimesAtTheEndsOfTheRangeIsNoNan) {
  const Interval mean = geometric_mean_ratio(
      {{{1e308, 1.7e308}, {5e-324, 1e-320}}, {{5e-324, 1e308}, {1.7e308, 1.7e308}}});
  EXPECT_TRUE(mean.low <= mean.value && mean.value <= mean.high) << mean.low << ' ' << mean.high;
}

TEST(GeometricMean, IsOfRatiosOfMediansWithAnIntervalAroundIt) {
  const Interval mean = geometric_mean_ratio({{{1, 1, 1}, {2, 2, 9}}, {{4, 4, 4}, {2, 2, 2}}});
  EXPECT_DOUBLE_EQ(mean.value, 1);
  EXPECT_DOUBLE_EQ(mean.low, 0.5);
  EXPECT_GT(mean.high, 2);
  const Interval constant = geometric_mean_ratio({{{2}, {3}}, {{4}, {6}}});
  EXPECT_DOUBLE_EQ(constant.low, 1.5);
  EXPECT_DOUBLE_EQ(constant.high, 1.5);
}

TEST(MedianInterval, IsOfOrderStatisticsThatASignTestLeaves) {
  const auto ends = [](std::size_t n) {
    std::vector<double> values;
    for (std::size_t i = n; i > 0; --i) values.push_back(static_cast<double>(i));
    const Interval interval = median_interval(values);
    return std::pair(interval.low, interval.high);
  };
  // Tables of the sign test at 5%: 0 of 6, 1 of 9, 3 of 15 and 7 of 25 values lie outside each end.
  EXPECT_EQ(ends(6), std::pair(1.0, 6.0));
  EXPECT_EQ(ends(9), std::pair(2.0, 8.0));
  EXPECT_EQ(ends(15), std::pair(4.0, 12.0));
  EXPECT_EQ(ends(25), std::pair(8.0, 18.0));
  EXPECT_EQ(ends(3000), std::pair(1446.0, 1555.0)) << "more outcomes than a double can count";
  EXPECT_EQ(ends(3), std::pair(1.0, 3.0)) << "too few: the range";
  EXPECT_DOUBLE_EQ(median_interval({4, 1, 3, 2}).value, 2.5);
}

TEST(GeometricMeanOfMedians, KeepsTheSamplesAndDrawsTheirValuesAnew) {
  const Interval constant = geometric_mean_of_medians({{2, 2, 2}, {8, 8, 8}});
  EXPECT_DOUBLE_EQ(constant.value, 4);
  EXPECT_DOUBLE_EQ(constant.low, 4) << "samples that differ widen nothing";
  EXPECT_DOUBLE_EQ(constant.high, 4);
  const Interval spread = geometric_mean_of_medians({{1, 2, 4}, {1, 2, 4}});
  EXPECT_DOUBLE_EQ(spread.value, 2);
  EXPECT_LT(spread.low, 1.5);
  EXPECT_GT(spread.high, 2.8);
  const Interval one = geometric_mean_of_medians({{1, 2, 3, 4, 5, 6, 7, 8, 9}});
  EXPECT_DOUBLE_EQ(one.low, 2) << "of one sample: the median's own";
}

TEST(Compare, OnlyResolvedDifferencesHaveARatioAndAreSlower) {
  const ResultFile before = file_of({{"mmp", kBefore}, {"ich", kBefore}});
  const ResultFile after = file_of({{"mmp", kSlower}, {"ich", kAlike}});
  const Comparison comparison = compare(before, after);
  ASSERT_EQ(comparison.cells.size(), 2u);
  EXPECT_TRUE(comparison.cells[0].time->resolved());
  EXPECT_FALSE(comparison.cells[1].time->resolved());
  EXPECT_EQ(failures(before, after, "time=10%"), 2u) << "the cell, and the solver's mean";
  EXPECT_EQ(failures(before, after, "time=30%"), 0u);
  const std::string text = report(comparison, {}, ReportFormat::text);
  EXPECT_EQ(text.find("2 cells compared: 1 slower, 0 faster, 1 not resolved (~)"), 0u) << text;
  EXPECT_NE(text.find("1.198"), std::string::npos) << text;
  ASSERT_EQ(comparison.overall.size(), 3u);
  EXPECT_EQ(comparison.overall.back().of, "all");
}

TEST(Compare, FewRepetitionsResolveNothingAndTheNoteSaysSo) {
  const Comparison comparison =
      compare(file_of({{"mmp", {10, 10, 10}}}), file_of({{"mmp", {20, 20, 20}}}));
  EXPECT_FALSE(comparison.cells[0].time->resolved());
  ASSERT_EQ(comparison.notes.size(), 1u);
  EXPECT_NE(comparison.notes[0].find("--repetitions 5"), std::string::npos);
}

TEST(Compare, CountersAndMemoryHaveLimitsOfTheirOwn) {
  const ResultFile before = file_of({{"mmp", kBefore}});
  ResultFile after = before;
  set_number(after, "window_propagations", 1010);
  EXPECT_EQ(failures(before, after, "counters=1%"), 0u);
  EXPECT_EQ(failures(before, after, "counters=0%"), 1u);
  EXPECT_EQ(compare(before, after).cells[0].counters.size(), 1u);
  set_number(after, "window_propagations", 1011);
  EXPECT_EQ(failures(before, after, "counters=1%"), 1u);
  set_number(after, "window_propagations", 950);
  EXPECT_EQ(failures(before, after, "counters=0%"), 0u) << "fewer windows are no growth";

  after = before;
  set_number(after, "solver_peak_bytes", 1065000);
  EXPECT_EQ(failures(before, after, "memory=2%"), 0u) << "below the floor of 64 KiB";
  set_number(after, "solver_peak_bytes", 1066000);
  EXPECT_EQ(failures(before, after, "memory=2%"), 1u);
}

TEST(Compare, AFailedCellIsShownAndFailsWithAnyLimit) {
  const ResultFile before = file_of({{"mmp", kBefore}, {"ich", kBefore}});
  ResultFile after = before;
  fail(after.cells[1], "crashed");
  Comparison comparison = compare(before, after);
  EXPECT_EQ(comparison.count_lost(), 1u);
  EXPECT_EQ(comparison.count_wrong(), 0u);
  EXPECT_EQ(failures(before, after, "memory=2%"), 1u);
  EXPECT_TRUE(exceeded(comparison, {}).empty());
  EXPECT_NE(report(comparison, {}, ReportFormat::markdown).find("new crashed: vertex 7 is off"),
            std::string::npos);
  fail(after.cells[1], "wrong answer");
  comparison = compare(before, after);
  EXPECT_EQ(comparison.count_wrong(), 1u);
  EXPECT_EQ(report(comparison, {}, ReportFormat::text).find("WRONG: ich/cube/src:0"), 0u);
}

TEST(Compare, WhatCannotBeComparedIsAnError) {
  const ResultFile before = file_of({{"mmp", kBefore}});
  ResultFile after = before;
  after.context["geodesic_bench"]["corpus"] = "paper";
  expect_error([&] { compare(before, after); }, {"different corpora", "quick", "paper"});
  after = before;
  after.context["geodesic_bench"]["meshes"][0]["sha256"] = "01";
  expect_error([&] { compare(before, after); }, {"cube is another file"});
  expect_error([&] { compare(before, file_of({{"new-name", kBefore}})); }, {"no cell in common"});
  for (const char* limit : {"time", "time=", "time=x%", "time=-1%", "time=10", "speed=1%"}) {
    expect_error([&] { parse_limits({limit}); }, {std::string(limit).substr(0, 4)});
  }
}

TEST(Compare, RenamedAndNewSolversAreListedOnTheirSides) {
  const Comparison comparison = compare(file_of({{"mmp", kBefore}, {"old-name", kBefore}}),
                                        file_of({{"mmp", kBefore}, {"new-name", kBefore}}));
  EXPECT_EQ(comparison.only_before, std::vector<std::string>{"old-name/cube/src:0"});
  EXPECT_EQ(comparison.only_after, std::vector<std::string>{"new-name/cube/src:0"});
}

TEST(Compare, TimesOfDifferentProcessorsAreNotCompared) {
  const ResultFile before = file_of({{"mmp", kBefore}});
  ResultFile after = file_of({{"mmp", kSlower}});
  after.context["geodesic_bench"]["processor"] = "another";
  const Comparison comparison = compare(before, after);
  EXPECT_FALSE(comparison.cells[0].time);
  EXPECT_TRUE(comparison.overall.empty());
  EXPECT_EQ(failures(before, after, "time=0%"), 0u);
  EXPECT_EQ(comparison.notes.size(), 2u);
}

TEST(Export, AMedianRowIsOneThatWasMeasured) {
  const Json json =
      Json::parse(export_as("gbench-median", file_of({{"mmp", {5, 1, 9, 2}}, {"ich", {3}}})));
  ASSERT_EQ(json.at("benchmarks").size(), 2u);
  EXPECT_EQ(json.at("benchmarks")[0].at("cpu_time"), 2);
  EXPECT_EQ(json.at("benchmarks")[0].at("repetitions"), 1);
}

TEST(Export, AnUnknownFormatListsTheKnownOnes) {
  expect_error([] { export_as("xml", file_of({})); },
               {"no export format named 'xml'", "bencher", "csv", "gbench-median"});
}

}  // namespace
}  // namespace geodesic::harness
