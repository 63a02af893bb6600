// Progress: vertices reached of those that can be, in equal steps.
#include "solvers/core/sweep.h"

#include <gtest/gtest.h>

#include "solvers/core/solver.h"

namespace geodesic {
namespace {

/// A strip of triangles over `vertices` points, and as many isolated points.
Mesh strip(Index vertices) {
  TriangleSoup soup;
  for (Index v = 0; v < vertices; ++v) {
    soup.positions.push_back({static_cast<double>(v / 2), static_cast<double>(v % 2), 0});
  }
  for (Index v = 0; v + 2 < vertices; ++v) {
    soup.triangles.push_back(v % 2 == 0 ? Triangle{v, v + 2, v + 1} : Triangle{v, v + 1, v + 2});
  }
  for (Index v = 0; v < vertices; ++v) soup.positions.push_back({-1, -1, 0});
  return Mesh(soup);
}

Sweep started(const Mesh& mesh, const std::vector<Index>& sources) {
  Query query;
  for (const Index v : sources) query.sources.push_back({v, 0});
  Sweep sweep;
  sweep.start(mesh, query);
  return sweep;
}

TEST(Sweep, EndsAtOneWhenEveryVertexWithAPathIsReached) {
  const Mesh mesh = strip(10);
  Sweep sweep = started(mesh, {0});
  EXPECT_EQ(sweep.share(), 0);
  for (int i = 0; i < 5; ++i) sweep.reach(kInfinity);
  EXPECT_EQ(sweep.share(), 0.5);
  for (int i = 0; i < 5; ++i) sweep.reach(kInfinity);
  EXPECT_EQ(sweep.reached(), 10u);
  EXPECT_EQ(sweep.share(), 1);
  Sweep with_isolated = started(mesh, {3, 17});
  for (int i = 0; i < 11; ++i) with_isolated.reach(kInfinity);
  EXPECT_EQ(with_isolated.share(), 1);
}

TEST(Sweep, MakesNoProgressByReachingAVertexAgain) {
  Sweep sweep = started(strip(4), {0});
  sweep.reach(kInfinity);
  sweep.reach(3.0);
  EXPECT_EQ(sweep.reached(), 1u);
}

TEST(Sweep, MakesEqualSteps) {
  Sweep sweep = started(strip(6400), {0});
  std::vector<Index> steps;
  for (int i = 0; i < 6400; ++i) {
    sweep.reach(kInfinity);
    if (sweep.made_step()) steps.push_back(sweep.reached());
  }
  ASSERT_EQ(steps.size(), Sweep::kSteps);
  for (Index i = 0; i < steps.size(); ++i) EXPECT_EQ(steps[i], 100 * (i + 1));
  EXPECT_FALSE(sweep.made_step()) << "after the last step";
}

TEST(Sweep, TellsOfSeveralStepsAtOnceOnce) {
  Sweep sweep = started(strip(640), {0});
  EXPECT_FALSE(sweep.made_step());
  for (int i = 0; i < 35; ++i) sweep.reach(kInfinity);
  EXPECT_TRUE(sweep.made_step());
  EXPECT_FALSE(sweep.made_step());
  for (int i = 0; i < 4; ++i) sweep.reach(kInfinity);
  EXPECT_FALSE(sweep.made_step());
  sweep.reach(kInfinity);
  EXPECT_TRUE(sweep.made_step()) << "at 40, the fourth step";
}

}  // namespace
}  // namespace geodesic
