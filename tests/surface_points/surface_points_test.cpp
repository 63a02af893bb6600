// Tests for every solver that accepts any point of the surface and records paths. Distances are as
// if the points were vertices, last segments lead back to a root, and solves end at the targets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/point_solver.h"
#include "meshes/random.h"
#include "solvers/paths/paths.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

constexpr double kExact = 1e-12;

std::vector<std::string> exact_solvers_of_points() {
  std::vector<std::string> names;
  for (const Description* each : registered_solvers()) {
    if (each->exactness != Exactness::exact) continue;
    if (each->abilities.surface_sources && each->abilities.paths) names.push_back(each->name);
  }
  return names;
}

/// Points in faces, on edges and at vertices, some next to a corner, a side or each other.
std::vector<SurfacePoint> random_points(const Mesh& mesh, Random& random, std::size_t count) {
  std::vector<SurfacePoint> points;
  while (points.size() < count) {
    const Index face = random.below(mesh.face_count());
    const double share = random.below(2) == 0 ? random.between(0.1, 0.9) : 1e-15;
    const double other = random.between(0.1, 0.9) * (1 - share);
    points.push_back(point_in_face(mesh, face, {other, share, 1 - share - other}));
    points.push_back(point_in_face(mesh, face, {share, 0, 1 - share}));
    points.push_back(point_in_face(mesh, face, {1, 2e-15, random.between(0, 1e-12)}));
    points.push_back(mesh.numbers().external_vertex(mesh.triangle(face)[0]));
  }
  points.resize(count);
  return points;
}

/// One to four sources, some nearly equal, most within reach of each other.
Query random_query(const Mesh& mesh, Random& random, std::vector<SurfacePoint> targets) {
  Query query{.sources = {}, .targets = std::move(targets)};
  const std::vector<SurfacePoint> points = random_points(mesh, random, 16);
  const std::uint32_t count = 1 + random.below(4);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double distance = random.below(3) == 0 ? random.between(0, 0.5) : 0;
    query.sources.push_back({points[random.below(16)], distance});
  }
  return query;
}

struct Answer {
  std::vector<double> distances;
  Recording recording;
};

Answer solve_recording_paths(const std::string& solver, const Mesh& mesh, const Query& query) {
  Answer answer;
  answer.recording.kind = RecordingKind::paths;
  answer.distances = distances_by(solver, mesh, query, &answer.recording);
  return answer;
}

class SurfacePoints : public testing::TestWithParam<std::string> {
 protected:
  bool takes(const Mesh& mesh) const {
    return !mesh.has_degenerate_faces() || solver_named(GetParam()).abilities.degenerate_faces;
  }
};

void expect_near(double is, double expected, double place) {
  if (expected == kInfinity) {
    EXPECT_EQ(is, kInfinity);
  } else {
    EXPECT_LE(std::abs(is - expected), kExact * expected + 4 * place) << is << " " << expected;
  }
}

/// Meshes without zero-area faces, which are not split at points inside them.
std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> meshes = random_meshes();
  meshes.push_back({"missing_faces", with_missing_faces(rough_terrain(3, 8, 8, 0.5), 3, 5)});
  meshes.push_back({"collapsed_edges", with_collapsed_edges(rough_sphere(3, 1, 0.2), 3, 10)});
  return meshes;
}

TEST_P(SurfacePoints, have_the_distances_of_vertices_in_their_place) {
  Random random(1);
  for (const NamedMesh& each : meshes()) {
    SCOPED_TRACE(each.name);
    const Mesh mesh(each.soup, Numbering::along_surface);
    if (!takes(mesh)) continue;
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(i);
      const Query query = random_query(mesh, random, random_points(mesh, random, 12));
      const Answer answer = solve_recording_paths(GetParam(), mesh, query);
      std::vector<SurfacePoint> points = query.targets;
      for (const Source& source : query.sources) points.push_back(source.at);
      const InsertedPoints inserted(mesh, points);
      const Query finer = inserted.translated(query);
      const std::vector<double> expected = distances_by("edge-based", inserted.mesh(), finer);
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        SCOPED_TRACE("vertex " + std::to_string(v));
        expect_near(answer.distances[v], expected[v], inserted.place());
      }
      for (std::size_t t = 0; t < query.targets.size(); ++t) {
        SCOPED_TRACE("target " + std::to_string(t));
        expect_near(answer.recording.targets[t].distance, expected[finer.targets[t].vertex],
                    inserted.place());
      }
      EXPECT_EQ(distances_by(GetParam(), mesh, query), answer.distances) << "timed, not recorded";
    }
  }
}

// In the plane, all distances are Euclidean, whatever faces lie between the points.
TEST_P(SurfacePoints, on_faces_without_area_are_as_far_as_in_space) {
  const Mesh mesh(with_flat_caps(generate("grid", {{"columns", 6}, {"rows", 5}}), 4, 3));
  ASSERT_TRUE(mesh.has_degenerate_faces());
  if (!takes(mesh)) return;
  Random random(5);
  const std::vector<SurfacePoint> targets = random_points(mesh, random, 60);
  for (const SurfacePoint& source : random_points(mesh, random, 60)) {
    const Vec3 from = position_of(mesh, source);
    const auto expect = [&](double distance, const SurfacePoint& to) {
      expect_near(distance, norm(subtract(position_of(mesh, to), from)), 1e-15);
    };
    const Answer answer =
        solve_recording_paths(GetParam(), mesh, {.sources = {{source}}, .targets = targets});
    for (Index v = 0; v < mesh.vertex_count(); ++v) expect(answer.distances[v], v);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      expect(answer.recording.targets[t].distance, targets[t]);
    }
  }
}

/// Expects the distances and path lengths of the targets from a solve without them. At the limit,
/// rounding may decide differently.
/// @param keeps_windows whether these are looked at, and give the same bits; otherwise it is a
///        search
void expect_same_without_targets(Solver& solver, const Mesh& mesh, const Query& query,
                                 bool keeps_windows) {
  const Paths with = solve_paths(solver, mesh, query);
  const Paths paths =
      solve_paths(solver, mesh, {.sources = query.sources, .limit = query.limit}, keeps_windows);
  const std::vector<double> distances = paths.distances_at(query.targets);
  for (std::size_t t = 0; t < query.targets.size(); ++t) {
    SCOPED_TRACE("target " + std::to_string(t));
    const double distance = paths.distance_at(query.targets[t]);
    EXPECT_EQ(distance, distances[t]);
    expect_near(distance, with.distance_to_target(t), 4e-16);
    if (keeps_windows) {
      EXPECT_EQ(distance, with.distance_to_target(t));
    }
    EXPECT_EQ(paths.nearest_source(query.targets[t]) == kNone, distance == kInfinity);
    if (distance == kInfinity) continue;
    const Path path = paths.to_point(query.targets[t]);
    expect_near(path.length() + query.sources[path.source].distance, distance, 1e-14);
    EXPECT_EQ(path.points.back().at, query.targets[t]);
    EXPECT_EQ(path.source, paths.nearest_source(query.targets[t]));
  }
}

TEST_P(SurfacePoints, have_the_distances_and_paths_of_targets_after_a_solve_without_them) {
  Random random(7);
  std::vector<NamedMesh> meshes = geodesic::meshes();
  meshes.push_back({"flat_caps", with_flat_caps(rough_terrain(4, 8, 8, 0.5), 4, 3)});
  for (const NamedMesh& each : meshes) {
    SCOPED_TRACE(each.name);
    const Mesh mesh(each.soup, Numbering::along_surface);
    if (!takes(mesh)) continue;
    const std::unique_ptr<Solver> solver = make_solver(GetParam(), mesh);
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(i);
      Query query = random_query(mesh, random, random_points(mesh, random, 40));
      for (const bool keeps_windows : {false, true}) {
        expect_same_without_targets(*solver, mesh, query, keeps_windows);
      }
      query.limit = random.between(0, 2);
      for (const bool keeps_windows : {false, true}) {
        expect_same_without_targets(*solver, mesh, query, keeps_windows);
      }
    }
  }
}

/// Whether a point is so near to a side or corner of its face that rounding decides by which face
/// its path arrives.
bool is_beside_a_side(const SurfacePoint& point) {
  return !point.is_vertex() &&
         std::ranges::any_of(point.weights, [](double w) { return 0 < w && w < 1e-6; });
}

// In a plane the distance is that in space, and its gradient leads away from the source.
TEST_P(SurfacePoints, have_gradients_that_lead_away_from_the_source_of_a_plane) {
  const Mesh mesh(generate("grid", {{"columns", 6}, {"rows", 5}}), Numbering::along_surface);
  const std::unique_ptr<Solver> solver = make_solver(GetParam(), mesh);
  Random random(11);
  const std::vector<SurfacePoint> ends = random_points(mesh, random, 60);
  for (const SurfacePoint& source : random_points(mesh, random, 12)) {
    const Paths paths = solve_paths(*solver, mesh, {.sources = {{source}}}, true);
    for (const SurfacePoint& end : ends) {
      const Vec3 way = subtract(position_of(mesh, end), position_of(mesh, source));
      const Vec3 gradient = paths.gradient_at(end);
      if (norm(way) < 1e-6 || is_beside_a_side(end)) continue;
      EXPECT_LE(norm(subtract(gradient, scale(1 / norm(way), way))), 1e-12 + 1e-15 / norm(way));
    }
    if (!source.is_vertex()) continue;
    EXPECT_TRUE(std::isnan(paths.gradient_at(source)[0]));
  }
}

TEST_P(SurfacePoints, have_gradients_in_which_their_paths_arrive) {
  Random random(12);
  for (const NamedMesh& each : random_meshes()) {
    SCOPED_TRACE(each.name);
    const Mesh mesh(each.soup, Numbering::along_surface);
    const std::unique_ptr<Solver> solver = make_solver(GetParam(), mesh);
    const Query query = random_query(mesh, random, {});
    const Paths paths = solve_paths(*solver, mesh, query, true);
    for (const SurfacePoint& end : random_points(mesh, random, 40)) {
      if (is_beside_a_side(end)) continue;
      const std::optional<Path> path = paths.find_to_point(end);
      if (!path || path->points.size() < 2) {
        EXPECT_TRUE(std::isnan(paths.gradient_at(end)[0]));
        continue;
      }
      const Vec3 last = subtract(path->points.back().position, path->points.rbegin()[1].position);
      if (norm(last) < 1e-4) continue;  // rounding turns a short piece
      EXPECT_LE(norm(subtract(paths.gradient_at(end), scale(1 / norm(last), last))), 1e-9);
    }
  }
}

double distance_of_root(const Mesh& mesh, const Query& query, const Answer& answer, Index root) {
  if (root < mesh.vertex_count()) return answer.distances[root];
  return query.sources[root - mesh.vertex_count()].distance;
}

TEST_P(SurfacePoints, arrive_from_roots_that_are_as_much_nearer_as_the_line_is_long) {
  Random random(3);
  for (const NamedMesh& each : meshes()) {
    SCOPED_TRACE(each.name);
    const Mesh mesh(each.soup);
    if (!takes(mesh)) continue;
    const Query query = random_query(mesh, random, random_points(mesh, random, 12));
    const Answer answer = solve_recording_paths(GetParam(), mesh, query);
    const auto expect_length = [&](const LastSegment& last_segment, const Point2& end,
                                   double distance) {
      const double line = std::hypot(last_segment.from.x - end.x, last_segment.from.y - end.y);
      const double before = distance_of_root(mesh, query, answer, last_segment.root);
      EXPECT_LE(std::abs(before + line - distance), kExact * distance + 1e-15);
    };
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      SCOPED_TRACE("vertex " + std::to_string(v));
      const LastSegment& last_segment = answer.recording.last_segments[v];
      EXPECT_EQ(last_segment.root == kNone, answer.distances[v] == kInfinity);
      if (last_segment.half_edge == kNone) {
        EXPECT_TRUE(last_segment.root == kNone || last_segment.root == v);
        continue;
      }
      EXPECT_EQ(mesh.apex(last_segment.half_edge), v);
      const HalfEdge& e = mesh.half_edge(last_segment.half_edge);
      expect_length(last_segment, {e.apex_x, e.apex_y}, answer.distances[v]);
    }
    for (std::size_t t = 0; t < query.targets.size(); ++t) {
      SCOPED_TRACE("target " + std::to_string(t));
      const auto& [distance, last_segment] = answer.recording.targets[t];
      if (query.targets[t].is_vertex() || last_segment.root == kNone) continue;
      const std::vector<InternalPoint> images =
          in_every_face(mesh, in_internal_numbers(mesh, query.targets[t]));
      const auto in_face =
          std::ranges::find(images, last_segment.half_edge / 3, &InternalPoint::face);
      ASSERT_NE(in_face, images.end());
      expect_length(last_segment, in_frame(mesh, *in_face, last_segment.half_edge), distance);
    }
  }
}

TEST_P(SurfacePoints, within_a_limit_are_as_far_as_without) {
  Random random(4);
  for (const NamedMesh& each : random_meshes()) {
    const Mesh mesh(each.soup);
    Query query = random_query(mesh, random, random_points(mesh, random, 12));
    const Answer all = solve_recording_paths(GetParam(), mesh, query);
    query.limit = 0.4 * *std::ranges::max_element(all.distances);
    const Answer limited = solve_recording_paths(GetParam(), mesh, query);
    const auto within = [&](double d) { return d <= query.limit ? d : kInfinity; };
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_EQ(limited.distances[v], within(all.distances[v])) << each.name << " vertex " << v;
    }
    for (std::size_t t = 0; t < query.targets.size(); ++t) {
      EXPECT_EQ(limited.recording.targets[t].distance, within(all.recording.targets[t].distance))
          << each.name << " target " << t;
    }
  }
}

// A first-in first-out queue has no bound on the distances of waiting windows.
bool ends_early(const std::string& solver) {
  return base_name(solver) != "ch" && base_name(solver) != "template";
}

TEST_P(SurfacePoints, that_are_targets_end_a_solve_as_a_limit_at_the_farthest_would) {
  const Mesh mesh(generate("terrain", {{"columns", 40}, {"rows", 40}}), Numbering::along_surface);
  Random random(6);
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    Query query = random_query(mesh, random, random_points(mesh, random, 1 + random.below(3)));
    const Answer all = solve_recording_paths(GetParam(), mesh, query);
    query.stop_at_targets = true;
    const Answer stopped = solve_recording_paths(GetParam(), mesh, query);
    double farthest = 0;
    for (std::size_t t = 0; t < query.targets.size(); ++t) {
      const double expected = all.recording.targets[t].distance;
      expect_near(stopped.recording.targets[t].distance, expected, 1e-15);
      farthest = std::max(farthest, expected);
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (all.distances[v] <= farthest) expect_near(stopped.distances[v], all.distances[v], 1e-15);
    }
    if (!ends_early(GetParam())) continue;
    Query limited = query;
    limited.stop_at_targets = false;
    limited.limit = farthest;
    const std::uint64_t least = propagated_by(GetParam(), mesh, limited);
    EXPECT_LE(propagated_by(GetParam(), mesh, query), 1.3 * static_cast<double>(least) + 6);
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, SurfacePoints, testing::ValuesIn(exact_solvers_of_points()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace geodesic
