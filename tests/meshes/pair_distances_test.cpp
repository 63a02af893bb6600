#include "meshes/pair_distances.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"
#include "tests/message_of.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

const Mesh kSphere(rough_sphere(6, 3, 0.2), Numbering::along_surface);

std::vector<PointPair> random_pairs(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<PointPair> pairs;
  const auto vertex = [&] { return random.below(kSphere.vertex_count()); };
  while (pairs.size() < count) pairs.push_back({vertex(), vertex()});
  pairs.push_back(pairs.front());
  pairs.push_back({pairs.front().to, pairs.front().from});
  return pairs;
}

TEST(PairDistances, are_those_of_full_solves_in_the_order_of_the_pairs) {
  const std::vector<PointPair> pairs = random_pairs(1, 60);
  for (const std::string solver : {"edge-based", "mmp", "ich", "dijkstra", "straight-graph"}) {
    const std::vector<double> got = pair_distances(kSphere, pairs, solver);
    ASSERT_EQ(got.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double expected =
          distances_by(solver, kSphere, {.sources = {{pairs[i].from}}})[pairs[i].to.vertex];
      EXPECT_NEAR(got[i], expected, 1e-12 * expected) << solver << " pair " << i;
    }
  }
}

TEST(PairDistances, have_the_same_bits_on_any_number_of_threads) {
  const std::vector<PointPair> pairs = random_pairs(2, 60);
  const std::vector<double> alone = pair_distances(kSphere, pairs, "edge-based", 1);
  EXPECT_EQ(pair_distances(kSphere, pairs, "edge-based", 2), alone);
  EXPECT_EQ(pair_distances(kSphere, pairs, "edge-based", 5), alone);
}

TEST(PairDistances, begin_at_the_end_with_fewer_points_only_if_the_solver_is_exact) {
  const std::vector<PointPair> pairs = {{0, 9}, {1, 9}, {0, 8}, {2, 9}, {2, 8}};
  const auto sources = [&](const char* solver) {
    std::set<Index> vertices;
    const GroupedPairs grouped(solver_named(solver), pairs);
    for (const SurfacePoint& source : grouped.sources()) vertices.insert(source.vertex);
    EXPECT_EQ(vertices.size(), grouped.sources().size());
    EXPECT_EQ(grouped.targets().size(), pairs.size());
    return vertices;
  };
  EXPECT_EQ(sources("edge-based"), (std::set<Index>{8, 9}));
  EXPECT_EQ(sources("straight-graph"), (std::set<Index>{0, 1, 2}));
}

TEST(PairDistances, are_those_of_points_in_faces_whatever_the_solver_takes) {
  const SurfacePoint a = point_in_face(kSphere, 3, {0.2, 0.3, 0.5});
  const SurfacePoint b = point_in_face(kSphere, 90, {0.5, 0.5, 0});
  const std::vector<PointPair> pairs = {{a, b}, {a, a}, {7, b}, {b, a}, {7, 7}, {a, 7}};
  const std::vector<double> expected = pair_distances(kSphere, pairs, "edge-based");
  EXPECT_EQ(expected[1], 0);
  EXPECT_EQ(expected[4], 0);
  EXPECT_GT(expected[0], 0);
  EXPECT_NEAR(expected[0], expected[3], 1e-12 * expected[0]);
  for (const char* solver : {"mmp", "ich", "ch"}) {
    const std::vector<double> got = pair_distances(kSphere, pairs, solver);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_NEAR(got[i], expected[i], 1e-12 * expected[i]) << solver << " pair " << i;
    }
  }
}

TEST(PairDistances, are_infinite_where_no_path_leads_and_none_for_no_pairs) {
  const TriangleSoup two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                         {{0, 1, 2}, {3, 4, 5}}};
  const Mesh mesh(two, Numbering::along_surface);
  const std::vector<PointPair> pairs = {{0, 4}, {0, 1}};
  EXPECT_EQ(pair_distances(mesh, pairs), (std::vector<double>{kInfinity, 1}));
  EXPECT_TRUE(pair_distances(mesh, {}).empty());
}

TEST(PairDistances, of_points_that_the_mesh_does_not_have_are_refused) {
  const std::vector<PointPair> pairs = {{0, 1}, {0, 999'999}};
  EXPECT_EQ(message_of<std::invalid_argument>([&] { pair_distances(kSphere, pairs); }),
            "vertex 999999 is not in the mesh of 642 vertices");
  EXPECT_THROW(pair_distances(kSphere, pairs, "no-solver"), std::invalid_argument);
}

}  // namespace
}  // namespace geodesic
