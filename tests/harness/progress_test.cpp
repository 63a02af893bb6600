#include "harness/run/progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace geodesic::harness {
namespace {

// The captured standard error is no terminal, so the lines are those of a log.
TEST(CellLines, IsALineACellThatNamesItAndHowLongItTook) {
  Description solver{};
  solver.name = "s";
  PlannedMesh mesh;
  mesh.entry.name = "m";
  mesh.vertices = 100;
  const SourceSet seven = single_source(7), nine = single_source(9);
  const std::vector<Cell> cells{{&mesh, &seven, &solver}, {&mesh, &nine, &solver}};
  CellLines progress(cells, {.repetitions = 1, .min_time = 0.001});
  ::testing::internal::CaptureStderr();
  progress.working("reference by r");
  progress.ended("ok");
  progress.working("measuring");
  progress.ended("crashed");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "[1/2] s/m/src:7  ok  (0 s, about 0 s left)\n[2/2] s/m/src:9  crashed  (0 s)\n")
      << "a line while a cell is measured comes after a minute";
}

// Two meshes, the second of twice as many vertices, each with two sources and the solvers `a` and
// `b`: cells a, b of the first source, then a, b of the second one.
class ForecastTest : public ::testing::Test {
 protected:
  ForecastTest() {
    for (PlannedMesh* mesh : {&small_, &large_}) {
      mesh->vertices = mesh == &small_ ? 1000 : 2000;
      mesh->sources = mesh->run_sources = {first_, second_};
      for (const SourceSet& source : mesh->sources) {
        for (const Description* solver : {&a_, &b_}) cells_.push_back({mesh, &source, solver});
      }
    }
  }

  const SourceSet first_ = single_source(0), second_ = single_source(1);
  const Description a_{}, b_{};
  PlannedMesh small_, large_;
  std::vector<Cell> cells_;
};

constexpr double kRounding = 1e-9;

TEST_F(ForecastTest, IsThatOfThePaceOfEachSolver) {
  Forecast forecast(cells_, {.repetitions = 3, .min_time = 0});
  const double least = Forecast(cells_, {.repetitions = 3, .min_time = 0}).seconds_left(7);
  forecast.measured(0, 1 + least);
  EXPECT_NEAR(forecast.seconds_left(2) - forecast.seconds_left(3), 1 + least, kRounding);
  EXPECT_NEAR(forecast.seconds_left(3) - forecast.seconds_left(4), 1 + least, kRounding)
      << "a solver without a measured cell has the mean pace of the others";
  forecast.measured(1, 10 + least);
  EXPECT_NEAR(forecast.seconds_left(2) - forecast.seconds_left(3), 1 + least, kRounding);
  EXPECT_NEAR(forecast.seconds_left(3) - forecast.seconds_left(4), 10 + least, kRounding);
  const double larger = forecast.seconds_left(7) - least;
  EXPECT_GT(larger, 20);
  EXPECT_LT(larger, 40) << "less than the square of the vertices";
}

TEST_F(ForecastTest, FollowsTheLastCellsOfASolver) {
  Forecast forecast(cells_, {.repetitions = 3, .min_time = 0});
  forecast.measured(0, 1);
  const double before = forecast.seconds_left(4);
  forecast.measured(2, 100);
  EXPECT_GT(forecast.seconds_left(4), 50 * before);
}

TEST_F(ForecastTest, CountsFurtherSourcesAndTheLeastTimeOfRepetitions) {
  small_.further_sources.assign(1000, 0);
  const Suite suite{.repetitions = 2, .min_time = 5};
  Forecast forecast(cells_, suite);
  EXPECT_NEAR(forecast.seconds_left(7), 10, 1) << "before any cell: what every solver takes";
  forecast.measured(0, 10 + 1005);
  EXPECT_NEAR(forecast.seconds_left(1) - forecast.seconds_left(2), 10 + 1005, 1);
  EXPECT_NEAR(forecast.seconds_left(2) - forecast.seconds_left(3), 10 + 5, 1);
}

}  // namespace
}  // namespace geodesic::harness
