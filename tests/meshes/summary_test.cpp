#include "meshes/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "meshes/repair.h"
#include "solvers/core/mesh.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

// A grid of n x n vertices, closed in one or both directions by identifying opposite sides; its
// position in space does not matter for the topology.
TriangleSoup grid(Index n, bool close_u, bool close_v) {
  TriangleSoup soup;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      soup.positions.push_back({static_cast<double>(i), static_cast<double>(j), 0});
    }
  }
  const auto id = [&](Index i, Index j) { return (i % n) * n + j % n; };
  for (Index i = 0; i + (close_u ? 0 : 1) < n; ++i) {
    for (Index j = 0; j + (close_v ? 0 : 1) < n; ++j) {
      soup.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      soup.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return soup;
}

void append(TriangleSoup& soup, const TriangleSoup& other) {
  const auto shift = static_cast<Index>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) {
    soup.triangles.push_back({a + shift, b + shift, c + shift});
  }
}

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
  const MeshSummary disc = summarize(grid(5, false, false));
  EXPECT_EQ(disc.boundary_loops, 1u);
  EXPECT_EQ(disc.boundary_edges, 16u);
  EXPECT_EQ(disc.genus, 0u);
  const MeshSummary annulus = summarize(grid(5, true, false));
  EXPECT_EQ(annulus.boundary_loops, 2u);
  EXPECT_EQ(annulus.genus, 0u);
  const MeshSummary torus = summarize(grid(5, true, true));
  EXPECT_EQ(torus.boundary_loops, 0u);
  EXPECT_EQ(torus.genus, 1u);
}

TEST(Summary, AddsUpOverComponents) {
  TriangleSoup soup = grid(5, true, true);
  append(soup, grid(4, true, true));
  append(soup, grid(5, false, false));
  append(soup, tetrahedron());
  soup.positions.push_back({9, 9, 9});
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
  TriangleSoup soup = grid(5, true, true);
  for (std::size_t f = 0; f < soup.triangles.size(); f += 3) {
    std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  }
  const MeshSummary s = summarize(soup);
  EXPECT_EQ(s.boundary_loops, 0u);
  EXPECT_EQ(s.genus, 1u);
}

TEST(Summary, CountsInteriorVerticesOfMoreThanAFullTurnAsSaddles) {
  // Vertex 0 in the middle of a rim whose height is constant (a cone), zero (flat) or alternating.
  constexpr Index kRim = 6;
  struct Case {
    double even, odd;
    std::size_t saddles;
  };
  for (const auto& [even, odd, saddles] :
       {Case{0.5, 0.5, 0}, Case{0, 0, 0}, Case{0.1, -0.1, 1}, Case{1e-3, -1e-3, 1}}) {
    TriangleSoup soup{.positions = {{0, 0, 0}}, .triangles = {}};
    for (Index i = 0; i < kRim; ++i) {
      const double angle = 2 * M_PI * i / kRim;
      soup.positions.push_back({std::cos(angle), std::sin(angle), i % 2 == 0 ? even : odd});
      soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % kRim});
    }
    EXPECT_EQ(summarize(soup).saddle_vertices, saddles)
        << "heights " << even << " and " << odd << ", total angle " << Mesh(soup).total_angle(0);
  }
}

TEST(Summary, AgreesWithTheSolversMesh) {
  const TriangleSoup soup = grid(6, false, true);
  const MeshSummary s = summarize(soup);
  const Mesh mesh(soup);
  EXPECT_EQ(s.edges, mesh.edge_count());
  EXPECT_NEAR(s.edge_lengths->mean, mesh.mean_edge_length(), 1e-14);
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
  constexpr Index kRim = 200'000;
  TriangleSoup soup;
  soup.positions.push_back({0, 0, 1});
  for (Index i = 0; i < kRim; ++i) {
    const double angle = 2 * M_PI * i / kRim;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % kRim});
  }
  EXPECT_EQ(summarize(soup).boundary_loops, 1u);
}

TEST(Summary, CountsTheFansOfANonManifoldVertexAsOneComponent) {
  TriangleSoup soup = tetrahedron();  // and another one that shares vertex 3 only
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

// Euler's formula gives whole numbers only if edges, loops, fans and pieces belong together.
TEST(Summary, OfAnyRepairedTrianglesIsThatOfTheSolversMesh) {
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
