#include "meshes/repair.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "meshes/defects.h"
#include "solvers/core/mesh.h"
#include "tests/meshes/mesh_samples.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

std::map<std::string, std::size_t> counts(const std::vector<RepairAction>& actions) {
  std::map<std::string, std::size_t> counts;
  for (const RepairAction& action : actions) counts[action.key] = action.count;
  return counts;
}

using Counts = std::map<std::string, std::size_t>;

TEST(Repair, LeavesACleanMeshAlone) {
  TriangleSoup soup = tetrahedron();
  EXPECT_TRUE(repair(soup).empty());
  EXPECT_EQ(soup.triangles, tetrahedron().triangles);
}

TEST(Repair, DropsUnusableFacesAndKeepsEveryVertexId) {
  TriangleSoup soup = tetrahedron();
  soup.positions.push_back({std::nan(""), 0, 0});
  soup.triangles.insert(soup.triangles.begin(), {{0, 1, 99}, {1, 1, 2}, {0, 1, 4}});
  soup.triangles.push_back({2, 1, 0});
  EXPECT_EQ(counts(repair(soup)), (Counts{{"dropped_index_out_of_range", 1},
                                          {"dropped_repeated_vertex", 1},
                                          {"dropped_at_non_finite_vertex", 1},
                                          {"moved_non_finite_vertex", 1},
                                          {"dropped_repeated_face", 1}}));
  EXPECT_EQ(soup.triangles, tetrahedron().triangles);
  EXPECT_EQ(soup.positions.size(), 5u);
  EXPECT_EQ(soup.positions[4], (Vec3{0, 0, 0}));
  EXPECT_EQ(soup.positions[1], tetrahedron().positions[1]);
}

TEST(Repair, FlipsFacesToRunAsTheFirstOfTheirPart) {
  TriangleSoup soup = tetrahedron();
  for (const std::size_t f : {1u, 3u}) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
  EXPECT_EQ(counts(repair(soup)), (Counts{{"flipped_faces", 2}}));
  EXPECT_EQ(soup.triangles, tetrahedron().triangles);

  std::swap(soup.triangles[0][1], soup.triangles[0][2]);  // the others are turned to match it
  EXPECT_EQ(counts(repair(soup)), (Counts{{"flipped_faces", 3}}));
  EXPECT_FALSE(find_defects(soup).has_errors());
}

TEST(Repair, CutsNonManifoldEdgesWithoutTouchingTheFile) {
  TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                    .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const auto triangles = soup.triangles;
  const std::vector<RepairAction> actions = repair(soup);
  EXPECT_EQ(counts(actions), (Counts{{"cut_non_manifold_edges", 1}}));
  EXPECT_FALSE(actions[0].changed);
  EXPECT_EQ(soup.triangles, triangles);
  const Mesh mesh(soup);
  for (const Index h : {0u, 3u, 6u}) EXPECT_EQ(mesh.twin(h), kNone) << "half-edge " << h;
}

TEST(Repair, SaysWhenASurfaceHasOneSideOnly) {
  TriangleSoup cylinder = band(8, false);
  EXPECT_TRUE(repair(cylinder).empty());
  TriangleSoup moebius = band(8, true);
  EXPECT_EQ(counts(repair(moebius)).at("cut_one_sided_edges"), 1u);
  EXPECT_EQ(find_defects(moebius).count(DefectKind::inconsistent_orientation), 1u);
}

TEST(Repair, KeepsDegenerateFacesAndIsolatedVertices) {
  TriangleSoup soup{.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}},
                    .triangles = {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_TRUE(repair(soup).empty());
  EXPECT_EQ(soup.triangles.size(), 2u);
  EXPECT_EQ(soup.positions.size(), 5u);
}

TEST(Repair, OfAnyTrianglesFitsTheSolversIsDeterministicAndIdempotent) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const TriangleSoup soup = random_triangles(random);
    TriangleSoup once = soup;
    TriangleSoup again = soup;
    const DefectReport report = find_defects(once);
    const std::vector<RepairAction> done = repair(once);
    for (const RepairAction& action : done) {
      EXPECT_GT(report.count(action.remedied.value()), 0u) << "round " << round << action.text;
    }
    const auto actions = counts(done);
    EXPECT_EQ(actions, counts(repair(again))) << "round " << round;
    EXPECT_EQ(once.triangles, again.triangles) << "round " << round;
    EXPECT_EQ(once.positions.size(), soup.positions.size());
    EXPECT_NO_THROW(Mesh{once}) << "round " << round;

    TriangleSoup twice = once;
    for (const RepairAction& action : repair(twice)) {
      EXPECT_FALSE(action.changed) << "round " << round << ": " << action.text;
      EXPECT_EQ(actions.at(action.key), action.count) << "round " << round;
    }
    EXPECT_EQ(twice.triangles, once.triangles) << "round " << round;
    EXPECT_EQ(twice.positions, once.positions) << "round " << round;
  }
}

}  // namespace
}  // namespace geodesic
