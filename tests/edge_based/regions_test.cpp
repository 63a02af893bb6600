// Regions of a mesh, and the wavefronts that process them in parallel. The properties test that the
// distances are right (tests/verify/property_test.cpp).
#include "solvers/edge_based/parallel/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_case.h"
#include "meshes/random.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/parallel/regional_wavefront.h"
#include "tests/delayed_pieces.h"
#include "tests/lowered_window_bound.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

using edge_based::InRegion;
using edge_based::Region;
using edge_based::RegionalWavefront;
using edge_based::Regions;

std::vector<Mesh> meshes() {
  std::vector<Mesh> all;
  const TriangleSoup terrain = generate("terrain", {{"columns", 45}, {"rows", 45}});
  all.emplace_back(terrain, Numbering::along_surface);
  all.emplace_back(terrain);
  all.emplace_back(generate("torus", {}));
  all.emplace_back(generate("cylinder", {}));  // many paths of equal length
  all.emplace_back(side_by_side(terrain, generate("two-components")));
  return all;
}

TEST(Regions, have_every_face_once_with_its_corners) {
  for (const Mesh& mesh : meshes()) {
    const Regions regions(mesh, 50, 2);
    ASSERT_GT(regions.size(), 10u);
    std::size_t faces = 0;
    for (Index r = 0; r < regions.size(); ++r) faces += regions[r].first_portal_face;
    EXPECT_EQ(faces, mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const InRegion at = regions.face(f);
      const Region& region = regions[at.region];
      for (Index k = 0; k < 3; ++k) {
        ASSERT_EQ(region.vertices[region.mesh.origin(3 * at.number + k)], mesh.origin(3 * f + k));
      }
    }
  }
}

TEST(Regions, lead_through_portals_where_twins_lead_in_the_mesh) {
  for (const Mesh& mesh : meshes()) {
    const Regions regions(mesh, 50, 2);
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      const InRegion at = regions.face(h / 3);
      const Region& region = regions[at.region];
      const Index own = 3 * at.number + h % 3, first = 3 * region.first_portal_face;
      const Index twin = region.mesh.twin(own);
      if (mesh.twin(h) == kNone) {
        ASSERT_EQ(twin, kNone);
        continue;
      }
      const InRegion face = regions.face(mesh.twin(h) / 3);
      const Index expected = 3 * face.number + mesh.twin(h) % 3;
      ASSERT_EQ(twin < first, face.region == at.region);
      ASSERT_EQ(twin < first ? twin : region.beyond[twin - first].number, expected);
      if (twin >= first) {
        ASSERT_EQ(region.beyond[twin - first].region, face.region);
      }
      ASSERT_EQ(region.mesh.half_edge(twin).apex_y, mesh.half_edge(mesh.twin(h)).apex_y);
    }
  }
}

TEST(Regions, have_all_copies_of_a_vertex) {
  for (const Mesh& mesh : meshes()) {
    const Regions regions(mesh, 50, 2);
    std::vector<std::size_t> copies(mesh.vertex_count(), 0);
    for (Index r = 0; r < regions.size(); ++r) {
      for (const Index v : regions[r].vertices) ++copies[v];
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      std::size_t found = 0;
      regions.for_each_copy(v, [&](const InRegion& copy) {
        EXPECT_EQ(regions[copy.region].vertices[copy.number], v);
        ++found;
      });
      ASSERT_EQ(found, copies[v]);
      ASSERT_GT(found, 0u);
    }
  }
}

// As where repair puts vertices of a scan in map coordinates at the origin.
TEST(Regions, are_the_same_beside_an_isolated_vertex_far_away) {
  TriangleSoup soup = generate("terrain", {{"columns", 45}, {"rows", 45}});
  const Regions alone(Mesh(soup), 50, 2);
  soup.positions.push_back({-5e6, -5e6, 0});
  const Regions beside(Mesh(soup), 50, 2);
  ASSERT_EQ(beside.size(), alone.size());
  for (Index r = 1; r < alone.size(); ++r) EXPECT_EQ(beside[r].vertices, alone[r].vertices);
}

TEST(Regions, are_small_where_another_component_is_far_away) {
  TriangleSoup soup = generate("terrain", {{"columns", 45}, {"rows", 45}});
  const Index first = static_cast<Index>(soup.positions.size());
  soup.positions.insert(soup.positions.end(),
                        {{5e6, 5e6, 0}, {5e6 + 1, 5e6, 0}, {5e6, 5e6 + 1, 0}});
  soup.triangles.push_back({first, first + 1, first + 2});
  EXPECT_GT(Regions(Mesh(soup), 50, 2).size(), soup.positions.size() / 50);
}

TEST(Regions, hold_the_vertices_of_a_mesh_without_faces) {
  const Regions regions(Mesh(TriangleSoup{{{0, 0, 0}, {1, 0, 0}}, {}}), 50, 2);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].vertices.size(), 2u);
}

Query random_query(const Mesh& mesh, std::uint64_t seed) {
  Random random(seed);
  Query query{.sources = {{random.below(mesh.vertex_count()), random.between(0, 1)}}};
  for (int i = 0; i < 3; ++i) {
    SurfacePoint in_face;
    in_face.face = random.below(mesh.face_count());
    in_face.weights = {0.5, 0.25, 0.25};
    if (i == 1) in_face.weights = {0.5, 0, 0.5};
    query.sources.push_back({in_face, random.between(0, 1)});
  }
  return query;
}

TEST(RegionalWavefront, gives_the_same_bits_on_any_number_of_threads_whenever_they_work) {
  std::uint64_t seed = 0;
  for (const Mesh& mesh : meshes()) {
    const Query query = random_query(mesh, ++seed);
    const auto expected = distances_by("edge-based?threads=2&region-size=30", mesh, query);
    const DelayedPieces delayed;
    for (const char* threads : {"3", "5", "16"}) {
      EXPECT_EQ(
          distances_by("edge-based?region-size=30&threads=" + std::string(threads), mesh, query),
          expected)
          << threads << " threads";
    }
  }
}

TEST(RegionalWavefront, gives_the_distances_of_the_serial_one_but_for_rounding) {
  std::uint64_t seed = 0;
  for (const Mesh& mesh : meshes()) {
    const Query query = random_query(mesh, ++seed);
    const auto serial = distances_by("edge-based", mesh, query);
    const auto regional = distances_by("edge-based?threads=2&region-size=30", mesh, query);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (serial[v] == regional[v]) continue;
      ASSERT_NEAR(regional[v], serial[v], 1e-14 * serial[v]) << "vertex " << v;
    }
  }
}

// A window may cross more faces than its region has, but not more than the mesh. Only on meshes
// with thin faces are they counted.
TEST(RegionalWavefront, sends_windows_through_more_thin_faces_than_a_region_has) {
  constexpr Index kCells = 300;
  TriangleSoup plate;  // 1 by 1
  for (Index i = 0; i <= kCells; ++i) {
    const double x = i / double{kCells};
    plate.positions.insert(plate.positions.end(), {{x, 0, 0}, {x, 1, 0}});
  }
  for (Index i = 0; i < 2 * kCells; i += 2) {
    plate.triangles.push_back({i, i + 2, i + 1});
    plate.triangles.push_back({i + 2, i + 3, i + 1});
  }
  const Mesh mesh(plate);
  ASSERT_TRUE(mesh.has_thin_faces());
  const auto distances =
      distances_by("edge-based?threads=2&region-size=30", mesh, {.sources = {{0}}});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& at = plate.positions[v];
    ASSERT_NEAR(distances[v], std::hypot(at[0], at[1]), 1e-13) << "vertex " << v;
  }
}

TEST(RegionalWavefront, gives_the_bits_of_the_serial_one_where_a_query_ends_early) {
  const Mesh mesh(generate("terrain", {{"columns", 45}, {"rows", 45}}));
  Query query = random_query(mesh, 1);
  query.limit = 2;
  EXPECT_EQ(distances_by("edge-based?threads=2&region-size=30", mesh, query),
            distances_by("edge-based", mesh, query));
}

TEST(RegionalWavefront, times_every_turn_where_it_is_asked_to) {
  const Mesh mesh(generate("terrain", {{"columns", 45}, {"rows", 45}}));
  const Query query{.sources = {{0}}};
  const auto count_turns = [](const RegionalWavefront::TurnTimes& steps) {
    std::size_t turns = 0;
    for (const auto& step : steps) turns += step.size();
    return turns;
  };
  RegionalWavefront regional(mesh, InstructionSet::plain, 1, 100);
  std::vector<double> timed(mesh.vertex_count()), untimed(mesh.vertex_count());
  RegionalWavefront::TurnTimes first, second;
  regional.run(Start(mesh, in_internal_numbers(mesh, query)), timed, &first);
  regional.run(Start(mesh, in_internal_numbers(mesh, query)), untimed);
  regional.run(Start(mesh, in_internal_numbers(mesh, query)), timed, &second);
  EXPECT_EQ(timed, untimed);
  EXPECT_GT(count_turns(first), 16u) << "of as many regions";
  EXPECT_EQ(count_turns(first), count_turns(second));
}

TEST(RegionalWavefront, throws_where_a_region_exceeds_the_bound_of_windows) {
  const Mesh mesh(generate("terrain", {{"columns", 45}, {"rows", 45}}));
  const LoweredWindowBound lowered(500);
  const auto regional = make_solver("edge-based?threads=3&region-size=200", mesh);
  std::vector<double> result(mesh.vertex_count());
  EXPECT_THROW(regional->solve({.sources = {{0}}}, result), EndlessPropagation);
}

TEST(Regions, give_the_same_bits_on_random_meshes_with_every_number_of_threads) {
  constexpr std::uint64_t kMeshes = 12;
  const DelayedPieces delayed;
  for (std::uint64_t number = 0; number < kMeshes; ++number) {
    const RandomCase made = random_case(1, number, ::testing::TempDir());
    const Mesh mesh(made.soup);
    Query query = made.query;
    query.limit = kInfinity;  // a query that ends early uses one thread
    const auto expected = distances_by("edge-based?threads=2&region-size=8", mesh, query);
    for (const char* solver :
         {"edge-based?threads=3&region-size=8", "edge-based?threads=5&region-size=8"}) {
      EXPECT_EQ(distances_by(solver, mesh, query), expected)
          << solver << " on mesh " << number << ", " << made.recipe;
    }
  }
}

}  // namespace
}  // namespace geodesic
