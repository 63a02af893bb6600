#include "meshes/topology.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "meshes/defects.h"
#include "meshes/repair.h"
#include "solvers/core/mesh.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

std::size_t vertices_in_file(const Topology& topology, Index v) {
  std::size_t count = 0;
  for (const auto vertex : topology.surface.vertices()) {
    if (topology.surface.property(topology.file_vertex, vertex) == v) ++count;
  }
  return count;
}

TEST(Topology, OfAClosedSurfaceHasTheFilesElements) {
  const Topology topology = build_topology(tetrahedron());
  EXPECT_EQ(topology.surface.n_vertices(), 4u);
  EXPECT_EQ(topology.surface.n_edges(), 6u);
  EXPECT_EQ(topology.surface.n_faces(), 4u);
  EXPECT_EQ(count_boundary_loops(topology.surface), 0u);
  EXPECT_EQ(count_components(topology), 1u);
  EXPECT_EQ(topology.extra_fans + topology.cut_edges + topology.left_out_faces, 0u);
}

TEST(Topology, SplitsANonManifoldVertexIntoAVertexAFan) {
  TriangleSoup soup = tetrahedron();  // and another one that shares vertex 3 only
  for (const Vec3& p : {Vec3{1, 0, 2}, Vec3{0, 1, 2}, Vec3{0, 0, 2}}) soup.positions.push_back(p);
  for (const Triangle& t : std::vector<Triangle>{{3, 4, 5}, {3, 5, 6}, {3, 6, 4}, {4, 6, 5}}) {
    soup.triangles.push_back(t);
  }
  const Topology topology = build_topology(soup);
  EXPECT_EQ(topology.extra_fans, 1u);
  EXPECT_EQ(vertices_in_file(topology, 3), 2u);
  EXPECT_EQ(topology.surface.n_faces(), 8u);
  EXPECT_EQ(count_pieces(topology.surface), 2u);
  EXPECT_EQ(count_components(topology), 1u);
}

TEST(Topology, OpensAnEdgeOfThreeFacesForEachOfThem) {
  const TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                          .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const Topology topology = build_topology(soup);
  EXPECT_EQ(topology.surface.n_faces(), 3u);
  EXPECT_EQ(topology.surface.n_edges(), 9u);
  EXPECT_EQ(topology.cut_edges, 1u);
  EXPECT_EQ(topology.extra_fans, 4u);
  EXPECT_EQ(count_boundary_loops(topology.surface), 3u);
  EXPECT_EQ(count_components(topology), 1u);
}

TEST(Topology, CountsWhatItLeavesOutAndTurns) {
  TriangleSoup soup = tetrahedron();
  std::swap(soup.triangles[1][1], soup.triangles[1][2]);
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({0, 1, 7});
  soup.triangles.push_back({0, 2, 1});
  const Topology topology = build_topology(soup);
  EXPECT_EQ(topology.left_out_faces, 3u);
  EXPECT_EQ(topology.flipped_faces, 1u);
  EXPECT_EQ(count_boundary_loops(topology.surface), 0u);
}

// Every link of the half-edge structure, walked with OpenMesh's own circulators.
void expect_sound(const Surface& surface, int round) {
  for (const auto h : surface.halfedges()) {
    ASSERT_TRUE(h.next().is_valid() && h.prev().is_valid()) << "round " << round;
    EXPECT_EQ(h.next().prev(), h) << "round " << round;
    EXPECT_EQ(h.next().from(), h.to()) << "round " << round;
    EXPECT_EQ(h.next().is_boundary(), h.is_boundary()) << "round " << round;
    EXPECT_NE(h.is_boundary() && h.opp().is_boundary(), true) << "round " << round;
  }
  std::size_t corners = 0;
  for (const auto v : surface.vertices()) {
    for ([[maybe_unused]] const auto f : v.faces()) ++corners;
    if (v.halfedge().is_valid() && surface.is_boundary(v)) {
      EXPECT_TRUE(v.halfedge().is_boundary()) << "round " << round;
    }
  }
  EXPECT_EQ(corners, 3 * surface.n_faces()) << "round " << round;
}

TEST(Topology, OfAnyTrianglesIsSoundAndThatOfTheSolversMesh) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    TriangleSoup soup;
    const std::size_t vertices = 4 + random() % 8;
    for (std::size_t v = 0; v < vertices; ++v) {
      soup.positions.push_back({static_cast<double>(random() % 100),
                                static_cast<double>(random() % 100), static_cast<double>(v)});
    }
    for (std::size_t f = 0; f < 3 + random() % 20; ++f) {
      const auto vertex = [&] { return static_cast<Index>(random() % vertices); };
      soup.triangles.push_back({vertex(), vertex(), vertex()});
    }
    repair(soup);
    const Topology topology = build_topology(soup);
    expect_sound(topology.surface, round);
    const Mesh mesh(soup);
    EXPECT_EQ(topology.surface.n_edges(), mesh.edge_count()) << "round " << round;
    EXPECT_EQ(topology.extra_fans > 0, mesh.has_non_manifold_vertices()) << "round " << round;
    for (const auto face : topology.surface.faces()) {
      EXPECT_EQ(topology.surface.property(topology.file_face, face),
                static_cast<Index>(face.idx()));
      Index k = 3 * static_cast<Index>(face.idx());
      for (const auto h : face.halfedges()) {
        EXPECT_EQ(topology.surface.property(topology.file_vertex, h.from()), mesh.origin(k));
        EXPECT_EQ(h.opp().is_boundary(), mesh.twin(k) == kNone) << "round " << round;
        ++k;
      }
    }
  }
}

}  // namespace
}  // namespace geodesic
