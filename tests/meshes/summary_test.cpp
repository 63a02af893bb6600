#include "meshes/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/repair.h"
#include "solvers/core/mesh.h"
#include "tests/meshes/mesh_samples.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

TriangleSoup small_torus() { return generate("torus", {{"rings", 5}, {"sides", 5}}); }

TEST(Summary, OfATetrahedronHasItsClosedForms) {
  const MeshSummary s = summarize(tetrahedron());
  EXPECT_EQ(s.vertices, 4u);
  EXPECT_EQ(s.faces, 4u);
  EXPECT_EQ(s.edges, 6u);
  EXPECT_EQ(s.components, 1u);
  EXPECT_EQ(s.boundary_loops, 0u);
  EXPECT_EQ(s.genus, 0u);
  EXPECT_EQ(s.saddle_vertices, 0u);
  ASSERT_TRUE(s.edge_lengths && s.smallest_angle);
  EXPECT_DOUBLE_EQ(s.edge_lengths->least, 1);
  EXPECT_DOUBLE_EQ(s.edge_lengths->greatest, std::sqrt(2));
  EXPECT_DOUBLE_EQ(s.edge_lengths->mean, (1 + std::sqrt(2)) / 2);
  EXPECT_DOUBLE_EQ(*s.smallest_angle, 45);
}

TEST(Summary, CountsLoopsAndGenus) {
  const MeshSummary disc = summarize(generate("grid", {{"columns", 4}, {"rows", 4}}));
  EXPECT_EQ(disc.boundary_loops, 1u);
  EXPECT_EQ(disc.boundary_edges, 16u);
  EXPECT_EQ(disc.genus, 0u);
  const MeshSummary annulus = summarize(generate("cylinder", {{"sides", 5}, {"rows", 4}}));
  EXPECT_EQ(annulus.boundary_loops, 2u);
  EXPECT_EQ(annulus.genus, 0u);
  const MeshSummary torus = summarize(small_torus());
  EXPECT_EQ(torus.boundary_loops, 0u);
  EXPECT_EQ(torus.genus, 1u);
}

TEST(Summary, AddsUpOverComponents) {
  TriangleSoup soup = small_torus();
  for (const TriangleSoup& more :
       {small_torus(), generate("grid"), tetrahedron(), TriangleSoup{{{9, 9, 9}}, {}}}) {
    soup = side_by_side(std::move(soup), more);
  }
  const MeshSummary s = summarize(soup);
  EXPECT_EQ(s.components, 4u);
  EXPECT_EQ(s.genus, 2u);
  EXPECT_EQ(s.boundary_loops, 1u);
  EXPECT_EQ(s.isolated_vertices, 1u);
}

TEST(Summary, HasNoGenusWhenTheSurfaceHasOneSideOnly) {
  // The projective plane of six vertices.
  TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}},
                    .triangles = {{0, 1, 4},
                                  {0, 4, 3},
                                  {0, 3, 2},
                                  {0, 2, 5},
                                  {0, 5, 1},
                                  {1, 2, 4},
                                  {2, 3, 1},
                                  {3, 4, 5},
                                  {4, 2, 5},
                                  {5, 3, 1}}};
  const MeshSummary s = summarize(soup);
  EXPECT_EQ(s.vertices - s.edges + s.faces + s.boundary_edges / 2, 1u);
  EXPECT_FALSE(s.orientable);
  EXPECT_FALSE(s.genus);
}

TEST(Summary, TakesMisorientedFacesAsIfTheyWereTurned) {
  TriangleSoup soup = small_torus();
  for (std::size_t f = 0; f < soup.triangles.size(); f += 3) {
    std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  }
  const MeshSummary s = summarize(soup);
  EXPECT_EQ(s.boundary_loops, 0u);
  EXPECT_EQ(s.genus, 1u);
}

TEST(Summary, CountsInteriorVerticesOfMoreThanAFullTurnAsSaddles) {
  EXPECT_EQ(summarize(fan(6, 0.5, 0.5)).saddle_vertices, 0u) << "a cone";
  EXPECT_EQ(summarize(fan(6, 0, 0)).saddle_vertices, 0u) << "flat";
  for (const double height : {0.1, 1e-3}) {
    EXPECT_EQ(summarize(fan(6, height, -height)).saddle_vertices, 1u) << height;
  }
}

TEST(Summary, OfUnusableFacesOnlyHasNoLengths) {
  const MeshSummary s = summarize({.positions = {{0, 0, 0}}, .triangles = {{0, 0, 0}}});
  EXPECT_EQ(s.left_out_faces, 1u);
  EXPECT_EQ(s.edges, 0u);
  EXPECT_FALSE(s.edge_lengths);
  EXPECT_FALSE(s.smallest_angle);
  EXPECT_EQ(s.genus, 0u);
}

TEST(Summary, OfAVertexOfManyFacesCostsNoQuadraticTime) {
  EXPECT_EQ(summarize(fan(200'000, 1, 1)).boundary_loops, 1u);
}

TEST(Summary, CountsTheFansOfANonManifoldVertexAsOneComponent) {
  TriangleSoup soup = tetrahedron();  // plus a second one that shares vertex 3 only
  for (const Vec3& p : {Vec3{1, 0, 2}, Vec3{0, 1, 2}, Vec3{0, 0, 2}}) soup.positions.push_back(p);
  for (const Triangle& t : std::vector<Triangle>{{3, 4, 5}, {3, 5, 6}, {3, 6, 4}, {4, 6, 5}}) {
    soup.triangles.push_back(t);
  }
  const MeshSummary s = summarize(soup);
  EXPECT_EQ(s.components, 1u);
  EXPECT_EQ(s.genus, 0u);
  EXPECT_EQ(s.edges, 12u);
}

TEST(Summary, CountsAnEdgeOfThreeFacesForEachOfThem) {
  const MeshSummary s =
      summarize({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                 .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  EXPECT_EQ(s.edges, 9u);
  EXPECT_EQ(s.boundary_edges, 9u);
  EXPECT_EQ(s.boundary_loops, 3u);
  EXPECT_EQ(s.components, 1u);
  EXPECT_EQ(s.genus, 0u);
}

TEST(Summary, LeavesOutUnusableFacesAndOrientsTheOthers) {
  TriangleSoup soup = tetrahedron();
  std::swap(soup.triangles[1][1], soup.triangles[1][2]);
  for (const Triangle& t : {Triangle{0, 0, 1}, {0, 1, 7}, {0, 2, 1}}) soup.triangles.push_back(t);
  const MeshSummary s = summarize(soup);
  EXPECT_EQ(s.left_out_faces, 3u);
  EXPECT_EQ(s.boundary_edges, 0u);
  EXPECT_EQ(s.genus, 0u);
}

// Euler's formula gives integers only if the counts of edges, loops, fans and components agree.
TEST(Summary, OfAnyRepairedTrianglesIsThatOfTheSolversMesh) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    TriangleSoup soup = random_triangles(random);
    repair(soup);
    const MeshSummary s = summarize(soup);
    const Mesh mesh(soup);
    std::size_t boundary = 0;
    for (Index h = 0; h < mesh.half_edge_count(); ++h) boundary += mesh.twin(h) == kNone ? 1u : 0u;
    EXPECT_EQ(s.edges, mesh.edge_count()) << "round " << round;
    EXPECT_EQ(s.boundary_edges, boundary) << "round " << round;
    EXPECT_LE(s.components + s.boundary_loops, boundary + mesh.face_count()) << "round " << round;
    if (s.genus) {
      EXPECT_LE(*s.genus, mesh.face_count()) << "round " << round;
    }
    if (s.edge_lengths) {
      EXPECT_DOUBLE_EQ(s.edge_lengths->mean, mesh.mean_edge_length()) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace geodesic
