// Sources and targets at points of the surface, and how paths arrive there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "meshes/inserted_points.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

constexpr double kExact = 1e-12;
constexpr const char* kSolvers[] = {"edge-based", "edge-based-lazy", "edge-based-bucket"};

/// Meshes with everything that a source may lie next to.
std::vector<NamedMesh> meshes() {
  return {{"sphere", rough_sphere(1, 2, 0.3)},
          {"terrain", rough_terrain(2, 8, 7, 0.8)},
          {"ragged", with_missing_faces(rough_terrain(3, 8, 8, 0.6), 3, 6)},
          {"collapsed", with_collapsed_edges(rough_terrain(4, 7, 7, 0.7), 4, 12)},
          {"flat-caps", with_flat_caps(rough_torus(5, 12, 8, 0.3), 5, 8)}};
}

/// In faces and on edges, next to corners and sides.
SurfacePoint random_point(const Mesh& mesh, Random& random) {
  const Index face = random.below(mesh.face_count());
  const double t = random.between(0, 1);
  switch (random.below(6)) {
    case 0:
      return point_in_face(mesh, face, {t, 1 - t, 0});
    case 1:
      return point_in_face(mesh, face, {t, 1 - t, 1e-15});
    case 2:
      return point_in_face(mesh, face, {1e-15, 1e-15, 1});
    default:
      return point_in_face(mesh, face, {t, random.between(0, 1), random.between(0, 1)});
  }
}

/// As random_point, in a face that has an area: inserting a vertex into another one may cut it.
SurfacePoint random_place(const Mesh& mesh, Random& random) {
  for (;;) {
    const SurfacePoint point = random_point(mesh, random);
    if (point.is_vertex() || mesh.half_edge(3 * point.face).apex_y > 1e-9) return point;
  }
}

/// Up to `most` points, each with an initial distance; every second one in the face of another.
std::vector<Source> random_sources(const Mesh& mesh, Random& random, std::uint32_t most) {
  std::vector<Source> sources;
  for (std::uint32_t left = 1 + random.below(most); left > 0; --left) {
    sources.push_back({.at = random_point(mesh, random), .distance = 0});
    if (sources.size() > 1) sources.back().distance = random.between(0, 1);
    const SurfacePoint& at = sources.back().at;
    if (left % 2 == 0 && !at.is_vertex()) {
      sources.push_back({.at = point_in_face(mesh, at.face, {0.2, 0.5, 0.3}), .distance = 0.1});
    }
  }
  if (random.below(2) == 0) sources.push_back({.at = random.below(mesh.vertex_count())});
  return sources;
}

struct Answer {
  std::vector<double> distances;
  Recording recording;
};

Answer solve(const char* solver, const Mesh& mesh, const Query& query, bool recorded) {
  Answer answer;
  answer.distances.resize(mesh.vertex_count());
  answer.recording.what = Record::paths;
  make_solver(solver, mesh)->solve(query, answer.distances, recorded ? &answer.recording : nullptr);
  return answer;
}

void expect_equal(double distance, double expected, double place, const std::string& what) {
  if (distance == expected) return;  // infinity too
  EXPECT_LE(std::abs(distance - expected), kExact * expected + place) << what;
}

TEST(EdgeBasedSurface, distances_from_and_at_any_points_are_those_of_the_points_as_vertices) {
  Random random(1);
  for (const NamedMesh& each : meshes()) {
    const Mesh mesh(each.soup);
    for (int repetition = 0; repetition < 8; ++repetition) {
      SCOPED_TRACE(each.name + ", " + std::to_string(repetition));
      Query query{.sources = random_sources(mesh, random, 4)};
      for (int i = 0; i < 20; ++i) query.targets.push_back(random_place(mesh, random));
      std::vector<SurfacePoint> points = query.targets;
      for (const Source& source : query.sources) points.push_back(source.at);
      const InsertedPoints inserted(mesh, points);
      Query finer{.sources = query.sources};
      for (Source& source : finer.sources) source.at = inserted.vertex(source.at);
      const std::vector<double> expected = solve("mmp", inserted.mesh(), finer, false).distances;
      for (const char* solver : kSolvers) {
        const Answer answer = solve(solver, mesh, query, true);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
          expect_equal(answer.distances[v], expected[v], 4 * inserted.place(),
                       std::string(solver) + ", vertex " + std::to_string(v));
        }
        for (std::size_t i = 0; i < query.targets.size(); ++i) {
          expect_equal(answer.recording.targets[i].distance,
                       expected[inserted.vertex(query.targets[i])], 4 * inserted.place(),
                       std::string(solver) + ", target " + std::to_string(i));
        }
        EXPECT_EQ(solve(solver, mesh, query, false).distances, answer.distances) << solver;
      }
    }
  }
}

TEST(EdgeBasedSurface, distances_between_any_points_are_symmetric) {
  Random random(2);
  for (const NamedMesh& each : meshes()) {
    const Mesh mesh(each.soup);
    Query query;
    for (int i = 0; i < 16; ++i) query.targets.push_back(random_point(mesh, random));
    std::vector<std::vector<AtTarget>> rows;
    for (const SurfacePoint& source : query.targets) {
      query.sources = {{.at = source}};
      rows.push_back(solve("edge-based", mesh, query, true).recording.targets);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i][i].distance, 0) << each.name << i;
      for (std::size_t k = 0; k < i; ++k) {
        expect_equal(rows[i][k].distance, rows[k][i].distance, 1e-15,
                     each.name + ": " + std::to_string(i) + " to " + std::to_string(k));
      }
    }
  }
}

/// Sources and targets at all kinds of points, in the mesh's own numbers: as given.
TEST(EdgeBasedSurface, arrivals_are_as_long_as_distances_say) {
  Random random(3);
  for (const NamedMesh& each : meshes()) {
    const Mesh mesh(each.soup);
    const Index vertices = mesh.vertex_count();
    for (const char* solver : kSolvers) {
      Query query{.sources = random_sources(mesh, random, 4)};
      for (int i = 0; i < 20; ++i) query.targets.push_back(random_point(mesh, random));
      const auto [distances, recording] = solve(solver, mesh, query, true);
      const auto at_root = [&](Index root) {
        return root < vertices ? distances[root] : query.sources[root - vertices].distance;
      };
      for (Index v = 0; v < vertices; ++v) {
        SCOPED_TRACE(each.name + ", " + solver + ", vertex " + std::to_string(v));
        const Arrival& arrival = recording.arrivals[v];
        if (distances[v] == kInfinity) {
          EXPECT_EQ(arrival, Arrival());
          continue;
        }
        if (arrival.half_edge == kNone) {
          EXPECT_EQ(arrival.root, v);
          const auto is_here = [&](const Source& s) { return s.at == SurfacePoint(v); };
          EXPECT_TRUE(std::ranges::any_of(query.sources, is_here));
          continue;
        }
        ASSERT_EQ(mesh.apex(arrival.half_edge), v);
        const HalfEdge& e = mesh.half_edge(arrival.half_edge);
        const double piece = std::hypot(e.apex_x - arrival.from.x, e.apex_y - arrival.from.y);
        expect_equal(at_root(arrival.root) + piece, distances[v], 1e-15, "");
      }
      for (std::size_t i = 0; i < query.targets.size(); ++i) {
        SCOPED_TRACE(each.name + ", " + solver + ", target " + std::to_string(i));
        const auto& [distance, arrival] = recording.targets[i];
        if (query.targets[i].is_vertex() || distance == kInfinity) continue;
        const SurfacePoint& target = query.targets[i];
        const SurfacePoint in_face =
            arrival.half_edge / 3 == target.face ? target : beyond_edge(mesh, target);
        ASSERT_EQ(in_face.face, arrival.half_edge / 3);
        const Point2 at = in_frame(mesh, in_face, arrival.half_edge);
        const double piece = std::hypot(at.x - arrival.from.x, at.y - arrival.from.y);
        expect_equal(at_root(arrival.root) + piece, distance, 1e-15, "");
      }
    }
  }
}

}  // namespace
}  // namespace geodesic
