// Progress: the share of reachable vertices that are reached, in equal steps.
#include "solvers/core/progress.h"

#include <gtest/gtest.h>

namespace geodesic {
namespace {

/// A strip of triangles over `vertices` points, and as many isolated points.
Mesh strip(Index vertices) {
  TriangleSoup soup;
  for (Index v = 0; v < vertices; ++v) {
    const Index column = v / 2;
    soup.positions.push_back({static_cast<double>(column), static_cast<double>(v % 2), 0});
  }
  for (Index v = 0; v + 2 < vertices; ++v) {
    soup.triangles.push_back(v % 2 == 0 ? Triangle{v, v + 2, v + 1} : Triangle{v, v + 1, v + 2});
  }
  for (Index v = 0; v < vertices; ++v) soup.positions.push_back({-1, -1, 0});
  return Mesh(soup);
}

Progress started(const Mesh& mesh, const std::vector<Index>& sources) {
  Query query;
  for (const Index v : sources) query.sources.push_back({v});
  Progress progress;
  progress.start(mesh, Start(mesh, in_internal_numbers(mesh, query)));
  return progress;
}

TEST(Progress, EndsAtOneWhenEveryVertexWithAPathIsReached) {
  const Mesh mesh = strip(10);
  Progress progress = started(mesh, {0});
  EXPECT_EQ(progress.share(), 0);
  for (int i = 0; i < 5; ++i) progress.improved(kInfinity);
  EXPECT_EQ(progress.share(), 0.5);
  for (int i = 0; i < 5; ++i) progress.improved(kInfinity);
  EXPECT_EQ(progress.reached(), 10u);
  EXPECT_EQ(progress.share(), 1);
  Progress with_isolated = started(mesh, {3, 17});
  for (int i = 0; i < 11; ++i) with_isolated.improved(kInfinity);
  EXPECT_EQ(with_isolated.share(), 1);
}

TEST(Progress, MakesNoProgressByReachingAVertexAgain) {
  Progress progress = started(strip(4), {0});
  progress.improved(kInfinity);
  progress.improved(3.0);
  EXPECT_EQ(progress.reached(), 1u);
}

TEST(Progress, MakesEqualSteps) {
  Progress progress = started(strip(6400), {0});
  std::vector<Index> steps;
  for (int i = 0; i < 6400; ++i) {
    progress.improved(kInfinity);
    if (progress.made_step()) steps.push_back(progress.reached());
  }
  ASSERT_EQ(steps.size(), Progress::kSteps);
  for (Index i = 0; i < steps.size(); ++i) EXPECT_EQ(steps[i], 100 * (i + 1));
  EXPECT_FALSE(progress.made_step()) << "after the last step";
}

TEST(Progress, TellsOfSeveralStepsAtOnceOnce) {
  Progress progress = started(strip(640), {0});
  EXPECT_FALSE(progress.made_step());
  for (int i = 0; i < 35; ++i) progress.improved(kInfinity);
  EXPECT_TRUE(progress.made_step());
  EXPECT_FALSE(progress.made_step());
  for (int i = 0; i < 4; ++i) progress.improved(kInfinity);
  EXPECT_FALSE(progress.made_step());
  progress.improved(kInfinity);
  EXPECT_TRUE(progress.made_step()) << "at 40, the fourth step";
}

}  // namespace
}  // namespace geodesic
