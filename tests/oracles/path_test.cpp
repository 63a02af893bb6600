// Shortest paths traced from distances: their lengths, and the edges that they cross.
#include "meshes/oracles/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/random_meshes.h"

namespace geodesic {
namespace {

Vec3 point_on(const Mesh& mesh, const EdgeCrossing& crossing) {
  const HalfEdge& edge = mesh.half_edge(crossing.half_edge);
  const Vec3 &a = mesh.position(edge.origin), &b = mesh.position(mesh.head(crossing.half_edge));
  return add(a, scale(crossing.position / edge.length, subtract(b, a)));
}

double distance(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

// Sum of the distances between successive points of the piece.
double length_of(const Mesh& mesh, const StraightPiece& piece) {
  Vec3 at = mesh.position(piece.from);
  double length = 0;
  for (const EdgeCrossing& crossing : piece.crossings) {
    const Vec3 next = point_on(mesh, crossing);
    length += distance(at, next);
    EXPECT_NEAR(length, crossing.travelled, 1e-12 * length);
    at = next;
  }
  return length + distance(at, mesh.position(piece.to));
}

// Expects that each edge lies on the face behind the edge before it.
void expect_a_strip(const Mesh& mesh, const StraightPiece& piece) {
  for (std::size_t i = 0; i < piece.crossings.size(); ++i) {
    const Index h = piece.crossings[i].half_edge;
    EXPECT_GE(piece.crossings[i].position, 0);
    EXPECT_LE(piece.crossings[i].position, mesh.half_edge(h).length);
    const Index left = mesh.twin(h);  // the face that the path comes from
    ASSERT_NE(left, kNone);
    if (i == 0) {
      EXPECT_EQ(mesh.apex(left), piece.from);
    } else {
      EXPECT_EQ(left / 3, piece.crossings[i - 1].half_edge / 3);
    }
  }
  if (!piece.crossings.empty()) {
    EXPECT_EQ(mesh.apex(piece.crossings.back().half_edge), piece.to);
  }
}

/// @return number of pieces of all paths
int expect_paths(const Mesh& mesh, const std::vector<InternalSource>& sources,
                 const std::vector<double>& distances) {
  const auto is_source = [&](Index v) {
    return std::ranges::any_of(sources,
                               [v](const InternalSource& each) { return each.at.vertex == v; });
  };
  int pieces = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto path = shortest_path(mesh, sources, distances, v);
    if (path.empty()) {
      EXPECT_TRUE(std::isinf(distances[v]) || is_source(v)) << "vertex " << v;
      continue;
    }
    double length = distances[path.front().from];
    Index at = path.front().from;
    for (const StraightPiece& piece : path) {
      EXPECT_EQ(piece.from, at);
      expect_a_strip(mesh, piece);
      EXPECT_NEAR(length_of(mesh, piece), piece.length, 1e-12 * piece.length);
      length += piece.length;
      at = piece.to;
      ++pieces;
    }
    EXPECT_EQ(at, v);
    EXPECT_NEAR(length, distances[v], 1e-12 * distances[v]) << "vertex " << v;
  }
  return pieces;
}

TEST(ShortestPath, is_as_long_as_the_closed_form_says) {
  const std::vector<std::pair<std::string, GeneratorParameters>> shapes = {
      {"box", {{"x-cells", 3}, {"y-cells", 2}, {"z-cells", 1}}},
      {"cone", {{"sectors", 4}, {"angle", 90}, {"rings", 3}}},
      {"saddle-cone", {{"sectors", 6}, {"sector-angle", 80}, {"rings", 3}}},
      {"cylinder", {{"sides", 7}, {"rows", 3}}},
      {"square-with-hole", {{"hole", 2}, {"rim", 1}}}};
  for (const auto& [generator, parameters] : shapes) {
    SCOPED_TRACE(generator);
    const TriangleSoup soup = generate(generator, parameters);
    const auto distances = known_distances(generator, parameters, soup, 1).value();
    expect_paths(Mesh(soup), {{.at = InternalPoint(1)}}, distances);
  }
}

TEST(ShortestPath, bends_at_pseudo_sources_only) {
  for (const auto& [name, soup] : random_meshes()) {
    SCOPED_TRACE(name);
    const Mesh mesh(soup);
    const Query query{.sources = {{0, 0.5}, {mesh.vertex_count() / 2, 0}}};
    const auto distances = BruteForce(mesh).distances(query.sources);
    const auto sources = in_internal_numbers(mesh, query).sources;
    EXPECT_GT(expect_paths(mesh, sources, distances), static_cast<int>(mesh.vertex_count()) / 2);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const auto path = shortest_path(mesh, sources, distances, v);
      for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_TRUE(mesh.is_pseudo_source(path[i].from)) << "to vertex " << v;
      }
    }
  }
}

TEST(ShortestPath, does_not_exist_to_a_source_to_another_component_or_for_wrong_distances) {
  const Mesh mesh(side_by_side(rough_sphere(1, 1, 0.2), rough_terrain(2, 3, 3, 1)));
  const std::vector<InternalSource> sources{{.at = InternalPoint(3)}};
  std::vector<double> distances = BruteForce(mesh).distances(std::vector<Source>{{.at = 3}});
  EXPECT_TRUE(shortest_path(mesh, sources, distances, 3).empty());
  EXPECT_TRUE(shortest_path(mesh, sources, distances, 45).empty());
  EXPECT_FALSE(shortest_path(mesh, sources, distances, 20).empty());
  distances[20] *= 0.99;
  EXPECT_TRUE(shortest_path(mesh, sources, distances, 20).empty());
}

}  // namespace
}  // namespace geodesic
