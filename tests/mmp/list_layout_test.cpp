// Where windows of an edge's two sides do not meet, more of them are left, and none is missed.
#include "solvers/mmp/edge_lists.h"

#include <gtest/gtest.h>

#include "meshes/oracles/random_meshes.h"
#include "solvers/core/registry.h"

namespace geodesic::mmp {
namespace {

struct Solved {
  std::vector<double> distances;
  Recording recording;
};
Solved solve(const char* solver, const Mesh& mesh) {
  Solved solved{.distances = std::vector<double>(mesh.vertex_count()), .recording = {}};
  make_solver(solver, mesh)->solve({.sources = {{0}}}, solved.distances, &solved.recording);
  return solved;
}

TEST(ListLayout, names_an_edge_by_its_smaller_half_edge_or_each_side_by_its_own) {
  EXPECT_EQ(ListPerEdge::list(7, 3), 3u);
  EXPECT_EQ(ListPerEdge::list(3, 7), 3u);
  EXPECT_EQ(ListPerEdge::list(7, kNone), 7u);
  EXPECT_EQ(ListPerHalfEdge::list(7, 3), 7u);
  EXPECT_EQ(ListPerHalfEdge::list(3, 7), 3u);
}

TEST(ListLayout, of_one_list_an_edge_leaves_fewer_windows) {
  // A closed surface: behind the source's cut locus, windows of the other side beat all that go on.
  const Mesh mesh(rough_sphere(5, 3, 0.1));
  const Solved merged = solve("mmp", mesh), apart = solve("mmp-half-edge", mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(apart.distances[v], merged.distances[v], 1e-12 * merged.distances[v]) << v;
  }
  EXPECT_GT(*apart.recording.window_limit, *merged.recording.window_limit);
  EXPECT_GT(*apart.recording.window_propagations, *merged.recording.window_propagations);
}

}  // namespace
}  // namespace geodesic::mmp
