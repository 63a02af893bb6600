#include "harness/cells/progress.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

// Standard error of a captured test is no terminal: what a log gets.
TEST(Progress, IsALineACellThatNamesItAndHowLongItTook) {
  Description solver{};
  solver.name = "s";
  PlannedMesh mesh;
  mesh.entry.name = "m";
  mesh.vertices = 100;
  const std::vector<Cell> cells{{&mesh, 7, &solver}, {&mesh, 9, &solver}};
  Progress progress(cells);
  ::testing::internal::CaptureStderr();
  progress.working("reference by r");
  progress.ended("ok");
  progress.working("measuring");
  progress.ended("crashed");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "[1/2] s/m/src:7  ok  (0 s, about 0 s left)\n[2/2] s/m/src:9  crashed  (0 s)\n")
      << "what a cell is at is told after a minute only";
}

}  // namespace
}  // namespace geodesic::harness
