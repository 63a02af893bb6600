// The saddle vertex graph: its links, and the distances over them.
#include "solvers/straight_graph/discs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/delayed_pieces.h"
#include "tests/solved.h"

namespace geodesic::straight_graph {
namespace {

constexpr double kExact = 1e-12;
/// Greatest share by which a link is longer than its line.
constexpr double kRounding = 1.0 / (1 << 17);

std::vector<NamedMesh> meshes() {
  const TriangleSoup terrain = rough_terrain(3, 12, 12, 0.5);
  return {{"terrain", terrain},
          {"sphere", rough_sphere(32, 2, 0.1)},
          {"torus", rough_torus(5, 16, 8, 0.3)},
          {"holes", with_holes(terrain, 4, 3)}};
}

// These meshes are rough: no line passes through a vertex, and no two paths are equally short.
TEST(Discs, link_to_the_nearest_vertices_to_which_the_shortest_path_is_straight) {
  for (const NamedMesh& each : meshes()) {
    const Mesh mesh(each.soup);
    for (const Index size : {1U, 7U, 50U, 5000U}) {
      const Graph graph = build_disc_graph(mesh, size, 1);
      for (Index v = 0; v < mesh.vertex_count(); v += 7) {
        Recording recording;
        recording.kind = RecordingKind::paths;
        const std::vector<double> exact =
            distances_by("edge-based", mesh, {.sources = {{v}}}, &recording);
        std::vector<double> sorted = exact;
        std::ranges::sort(sorted);
        const double farthest = sorted[std::min<std::size_t>(size, sorted.size() - 1)];
        std::vector<Index> expected, found;
        for (Index u = 0; u < mesh.vertex_count(); ++u) {
          if (u == v || recording.last_segments[u].root != v) continue;
          if (exact[u] <= farthest * (1 + kExact)) expected.push_back(u);
        }
        const Block& block = graph.block(v);
        for (const Link& link : block.edges()) {
          EXPECT_GE(link.length(), exact[link.target()] * (1 - kExact));
        }
        for (const auto links : {block.edges(), block.links()}) {
          for (const Link& link : links) {
            const double distance = exact[link.target()];
            if (distance > farthest * (1 + kExact)) continue;
            found.push_back(link.target());
            EXPECT_GE(link.length(), distance * (1 - kExact)) << each.name << " " << v;
            EXPECT_LE(link.length(), distance * (1 + kRounding) * (1 + kExact))
                << each.name << " " << v;
          }
        }
        std::ranges::sort(found);
        EXPECT_EQ(found, expected) << each.name << ", vertex " << v << ", size " << size;
      }
    }
  }
}

TEST(Discs, always_link_to_all_neighbours_and_never_twice_to_one_vertex) {
  for (const NamedMesh& each : random_meshes()) {
    const Mesh mesh(each.soup);
    const Graph graph = build_disc_graph(mesh, 30, 1);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      std::vector<Index> neighbours, edges, all;
      for (const Index h : mesh.outgoing(v)) {
        neighbours.push_back(mesh.head(h));
        neighbours.push_back(mesh.apex(h));
      }
      std::ranges::sort(neighbours);
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      for (const Link& link : graph.block(v).edges()) edges.push_back(link.target());
      all = edges;
      for (const Link& link : graph.block(v).links()) all.push_back(link.target());
      std::ranges::sort(edges);
      std::ranges::sort(all);
      EXPECT_EQ(edges, neighbours) << each.name << ", vertex " << v;
      EXPECT_EQ(std::ranges::adjacent_find(all), all.end()) << each.name << ", vertex " << v;
      EXPECT_FALSE(std::ranges::binary_search(all, v)) << each.name << ", vertex " << v;
    }
  }
}

// Every shortest path is a chain of straight lines between saddle vertices.
TEST(SaddleVertexGraph, is_exact_up_to_rounding_with_discs_of_the_whole_mesh) {
  for (const NamedMesh& each : random_meshes()) {
    const Mesh mesh(each.soup);
    const Query query{.sources = {{0}}};
    const std::vector<double> exact = distances_by("edge-based", mesh, query);
    const std::vector<double> found = distances_by("saddle-vertex-graph?disc=10000", mesh, query);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_GE(found[v], exact[v] * (1 - kExact)) << each.name << ", vertex " << v;
      EXPECT_LE(found[v], exact[v] * (1 + kRounding) * (1 + kExact))
          << each.name << ", vertex " << v;
    }
  }
}

TEST(SaddleVertexGraph, is_nowhere_above_the_distance_along_edges_with_discs_of_one_vertex) {
  for (const NamedMesh& each : random_meshes()) {
    const Mesh mesh(each.soup);
    const Query query{.sources = {{0}}};
    const std::vector<double> along_edges = distances_by("dijkstra", mesh, query);
    const std::vector<double> found = distances_by("saddle-vertex-graph?disc=1", mesh, query);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_LE(found[v], along_edges[v] * (1 + kRounding) * (1 + kExact))
          << each.name << ", vertex " << v;
    }
  }
}

TEST(SaddleVertexGraph, has_the_same_bits_with_any_number_of_threads) {
  const Mesh mesh(generate("terrain"));
  ASSERT_GT(mesh.vertex_count(), 2048U);
  const Query query{.sources = {{5}}};
  const std::vector<double> one = distances_by("saddle-vertex-graph?disc=30", mesh, query);
  const DelayedPieces delayed;
  EXPECT_EQ(distances_by("saddle-vertex-graph?disc=30&threads=3", mesh, query), one);
}

}  // namespace
}  // namespace geodesic::straight_graph
