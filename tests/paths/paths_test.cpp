// Paths traced from their last segments, which come from brute force and not from a solver.
#include "solvers/paths/paths.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "harness/verify/path_check.h"
#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/core/registry.h"
#include "tests/message_of.h"
#include "tests/paths/oracle_paths.h"

namespace geodesic {
namespace {

std::string wrong_with(const harness::Finding& finding) { return finding ? finding->what : ""; }

// Checks the paths to all vertices that are reached. @return their number
int expect_shortest_paths(const Mesh& mesh, const Query& query) {
  const Paths paths = oracle_paths(mesh, query);
  int traced = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double distance = paths.distances()[v];
    if (distance == kInfinity) continue;
    const Path path = paths.to_vertex(v);
    EXPECT_EQ(wrong_with(harness::check_path(mesh, query, v, distance, path)), "") << v;
    EXPECT_EQ(wrong_with(harness::check_straight(mesh, path)), "") << v;
    ++traced;
  }
  return traced;
}

TEST(Paths, are_as_long_as_brute_force_says_and_straight) {
  for (const auto& [name, soup] : random_meshes()) {
    SCOPED_TRACE(name);
    const Mesh mesh(soup);
    EXPECT_GT(expect_shortest_paths(mesh, {.sources = {{0, 0.5}, {mesh.vertex_count() / 2, 0}}}),
              20);
  }
}

TEST(Paths, run_through_the_vertices_on_their_line) {
  const Mesh mesh(generate("grid", {{"columns", 4}, {"rows", 3}, {"diagonal", "forward"}}));
  EXPECT_EQ(expect_shortest_paths(mesh, {.sources = {{.at = 6}}}), 20);
  const Paths paths = oracle_paths(mesh, {.sources = {{.at = 0}}});
  const auto expect_line = [&](Index to, const std::vector<Index>& vertices) {
    const Path path = paths.to_vertex(to);
    ASSERT_EQ(path.points.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      EXPECT_EQ(path.points[i].at, SurfacePoint(vertices[i]));
    }
  };
  expect_line(4, {0, 1, 2, 3, 4});  // along the border
  expect_line(18, {0, 6, 12, 18});  // diagonals
  expect_line(0, {0});
}

TEST(Paths, are_those_of_the_numbers_given_however_a_mesh_numbers_itself) {
  const TriangleSoup soup = rough_sphere(6, 2, 0.2);
  const Mesh as_given(soup), renumbered(soup, Numbering::along_surface);
  ASSERT_FALSE(renumbered.numbers().is_identity());
  const Query query{.sources = {{.at = 5}}};
  const Paths paths = oracle_paths(as_given, query);
  // The same recording in the internal numbers of the other mesh.
  const MeshNumbers& numbers = renumbered.numbers();
  Recording recording;
  recording.kind = RecordingKind::paths;
  const InternalQuery own = in_internal_numbers(renumbered, query);
  for (Index v = 0; v < renumbered.vertex_count(); ++v) {
    std::vector<double> distances;
    for (Index u = 0; u < renumbered.vertex_count(); ++u) {
      distances.push_back(paths.distances()[numbers.external_vertex(u)]);
    }
    const auto path = shortest_path(renumbered, own.sources, distances, v);
    recording.last_segments.push_back(path.empty() ? LastSegment{kNone, v, {0, 0}}
                                                   : arrival_of(renumbered, path.back()));
  }
  const Paths same(renumbered, query, paths.distances(), recording);
  for (Index v = 0; v < renumbered.vertex_count(); ++v) {
    const Path path = same.to_vertex(v);
    EXPECT_EQ(wrong_with(harness::check_path(renumbered, query, v, paths.distances()[v], path)),
              "");
    EXPECT_EQ(path.points.size(), paths.to_vertex(v).points.size());
  }
}

// A square of two triangles: 0 (0, 0), 1 (1, 0), 2 (1, 1), 3 (0, 1).
const TriangleSoup kSquare{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};

TEST(Paths, lead_between_points_in_faces_and_on_edges) {
  const Mesh mesh(kSquare);
  const SurfacePoint below = point_in_face(mesh, 0, {0.25, 0.5, 0.25});
  const SurfacePoint above = point_in_face(mesh, 1, {0.25, 0.25, 0.5});
  const SurfacePoint middle = point_on_edge(mesh, 0, 2, 0.5);
  const Query query{.sources = {{below, 2}}, .targets = {above, middle, below, 3}};
  const Index root = mesh.vertex_count(), diagonal = 3;  // half-edge of face 1 from 0 to 2
  // The start in the frame of its twin, then in its own frame.
  const Point2 from_0 = in_frame(mesh, in_internal_numbers(mesh, below), 2);
  const Point2 from = {mesh.half_edge(diagonal).length - from_0.x, -from_0.y};
  const auto straight = [&](const SurfacePoint& end) {
    const Vec3 line = subtract(position_of(mesh, end), position_of(mesh, below));
    return AtTarget{2 + norm(line), {diagonal, root, from}};
  };
  Recording recording;
  recording.kind = RecordingKind::paths;
  recording.last_segments.assign(4, {});
  recording.last_segments[3] = {diagonal, root, from};
  std::vector<double> distances(4, kInfinity);
  distances[3] = straight(3).distance;
  recording.targets = {straight(above), straight(middle), {2, {2, root, from_0}}, straight(3)};
  const Paths paths(mesh, query, distances, recording);
  for (std::size_t i = 0; i < query.targets.size(); ++i) {
    const double distance = paths.distance_to_target(i);
    const Path path = paths.to_target(i);
    EXPECT_EQ(wrong_with(harness::check_path(mesh, query, query.targets[i], distance, path)), "");
    EXPECT_EQ(wrong_with(harness::check_straight(mesh, path)), "");
  }
  EXPECT_EQ(paths.to_target(0).points.size(), 3u);
  EXPECT_EQ(paths.to_target(1).points.size(), 2u);
  EXPECT_EQ(paths.to_target(2).points.size(), 1u);
  EXPECT_EQ(paths.nearest_sources(), (std::vector<Index>{kNone, kNone, kNone, 0}));
}

// Other vertices are too far away for a search to look there.
TEST(Paths, follow_lines_that_bend_nowhere_without_a_search) {
  const Mesh mesh(generate("icosphere", {{"frequency", 4}}));
  const Query query{.sources = {{.at = 0}}};
  const std::vector<double> distances = BruteForce(mesh).distances(query.sources);
  const Recording recording = oracle_recording(mesh, query, distances);
  for (Index v = 1; v < mesh.vertex_count(); ++v) {
    std::vector<double> others = distances;
    for (double& distance : others) distance *= 3;
    others[v] = distances[v];
    const Paths paths(mesh, query, others, recording);
    EXPECT_NEAR(paths.to_vertex(v).length(), distances[v], 1e-13) << v;
  }
}

// The source lies before a flat cap, the end next to the cap's apex, a saddle vertex, on the line
// of a side of the cap. Lines of sight along that side are rounded by more than the cap is high.
TEST(Paths, bend_at_the_apex_of_a_flat_cap_however_near_the_end_is) {
  const double height = 3.7e-9;
  const Mesh mesh(
      TriangleSoup{{{3, 0, 0},
                    {4 - height, 0, 0},
                    {4 - height, 4, 0},
                    {4, 1, 0},
                    {5, 0, 0},
                    {5, 1, 0},
                    {4, 2, 0},
                    {3, 2, 0}},
                   {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {4, 5, 3}, {5, 6, 3}, {6, 7, 3}, {7, 2, 3}}});
  for (const double near : {1e-6, 1e-8, 1e-9, 1e-10}) {
    const SurfacePoint end = point_on_edge(mesh, 3, 6, near);
    const Query query{.sources = {{.at = 0}}};
    const Paths paths = oracle_paths(mesh, query);
    const double expected = paths.distances()[3] + near;
    EXPECT_NEAR(paths.distance_at(end), expected, 1e-14) << near;
    EXPECT_NEAR(paths.to_point(end).length(), expected, 1e-14) << near;
  }
}

TEST(Paths, say_which_source_is_nearest_by_the_numbers_given) {
  const Mesh mesh(rough_sphere(6, 2, 0.2), Numbering::along_surface);
  const auto solver = make_solver("edge-based", mesh);
  const Paths paths = solve_paths(*solver, mesh, {.sources = {{.at = 5}, {.at = 90}}});
  const std::vector<Index> nearest = paths.nearest_sources();
  EXPECT_EQ(nearest[5], 0);
  EXPECT_EQ(nearest[90], 1);
  for (Index v = 0; v < nearest.size(); ++v) EXPECT_EQ(paths.nearest_source(v), nearest[v]);
}

TEST(Paths, say_which_source_is_nearest) {
  const Mesh mesh(side_by_side(kSquare, rough_sphere(2, 1, 0.1)));
  // Vertex 1 is a source twice. Vertex 2 is reached sooner than its own source starts.
  const Query query{.sources = {{1, 0.5}, {0, 0}, {1, 0.25}, {2, 7}}};
  const Paths paths = oracle_paths(mesh, query);
  std::vector<Index> expected(mesh.vertex_count(), kNone);
  expected[0] = expected[3] = 1;
  expected[1] = expected[2] = 2;
  EXPECT_EQ(paths.nearest_sources(), expected);
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(paths.nearest_source(v), expected[v]);
  EXPECT_EQ(paths.to_vertex(2).source, 2u);
  EXPECT_EQ(paths.to_vertex(2).length(), 1);
}

TEST(Paths, are_refused_where_none_leads) {
  const Mesh mesh(side_by_side(kSquare, kSquare));
  const Paths paths = oracle_paths(mesh, {.sources = {{.at = 0}}});
  const auto refused = [&](Index v) {
    return message_of<std::invalid_argument>([&] { paths.to_vertex(v); });
  };
  EXPECT_EQ(refused(5), "no path leads to vertex 5");
  EXPECT_EQ(refused(8), "vertex 8 is not in the mesh of 8 vertices");
  EXPECT_EQ(paths.nearest_source(5), kNone);
  EXPECT_THROW(paths.nearest_source(8), std::invalid_argument);
  for (const auto& call : std::vector<std::function<void()>>{
           [&] { paths.to_target(0); }, [&] { paths.find_to_target(0); },
           [&] { paths.distance_to_target(0); }}) {
    EXPECT_EQ(message_of<std::invalid_argument>(call), "target 0 is not in the query of 0 targets");
  }
}

TEST(Paths, traced_by_a_solver_need_one_distance_for_each_vertex) {
  const Mesh mesh(kSquare);
  const Query query{.sources = {{.at = 0}}};
  std::vector<double> distances(mesh.vertex_count());
  const auto solver = make_solver("dijkstra", mesh);
  solver->solve(query, distances);
  distances.pop_back();
  EXPECT_EQ(message_of<std::invalid_argument>([&] { solver->trace(query, distances, 2); }),
            "dijkstra: needs one distance a vertex");
}

TEST(Paths, need_a_recording_of_their_own_query) {
  const Mesh mesh(kSquare);
  Recording recording;
  const auto paths = [&](const Query& query) {
    return message_of<std::invalid_argument>(
        [&] { Paths(mesh, query, std::vector<double>(4), recording); });
  };
  const std::string refusal = "paths need a recording of paths, of this mesh and query";
  recording.last_segments.resize(4);
  EXPECT_EQ(paths({.sources = {{.at = 0}}}), refusal);  // the recording is one of counters
  recording.kind = RecordingKind::paths;
  EXPECT_EQ(paths({.sources = {{.at = 0}}}), "nothing was thrown");
  EXPECT_EQ(paths({.sources = {{.at = 0}}, .targets = {1}}), refusal);
  recording.last_segments.resize(3);
  EXPECT_EQ(paths({.sources = {{.at = 0}}}), refusal);
}

TEST(Paths, end_in_one_error_where_a_solver_remembers_nonsense) {
  const Mesh mesh(kSquare);
  const Query query{.sources = {{.at = 0}}};
  const auto with = [&](const LastSegment& to_1, const LastSegment& to_3) {
    Recording recording;
    recording.kind = RecordingKind::paths;
    recording.last_segments = {{kNone, 0, {0, 0}}, to_1, {1, 0, {0, 0}}, to_3};
    // The distance 0.5 is shorter than any path, so that no other path is taken.
    const Paths paths(mesh, query, {0, 1, std::sqrt(2), 0.5}, recording);
    return message_of<std::runtime_error>([&] { paths.to_vertex(3); });
  };
  const LastSegment fine{2, 0, {std::sqrt(2), 0}};
  const std::string lost = " that does not exist; please report this mesh and query";
  const std::string to_3 = "the solver remembers a path to vertex 3 from ";
  EXPECT_EQ(with(fine, {3, 0, {0, 0}}), to_3 + "vertex 0" + lost);       // longer than the distance
  EXPECT_EQ(with(fine, {3, 1, {5, 5}}), to_3 + "vertex 1" + lost);       // not beyond the edge
  EXPECT_EQ(with(fine, {3, 1, {-9, -1e-3}}), to_3 + "vertex 1" + lost);  // over the border
  EXPECT_EQ(with(fine, {3, 4, {0, -1}}), to_3 + "a source in a face" + lost);
  EXPECT_EQ(with(fine, {99, 0, {0, 0}}), to_3 + "vertex 0" + lost);
  EXPECT_EQ(with(fine, {kNone, kNone, {0, 0}}), to_3 + "nothing" + lost);
  const LastSegment across{3, 1, {std::sqrt(0.5), -std::sqrt(0.5)}}, back{2, 3, across.from};
  EXPECT_EQ(with({kNone, 1, {0, 0}}, across),  // vertex 1 is no source
            "the solver remembers a path to vertex 3 from vertex 1" + lost);
  EXPECT_NE(with(back, across).find(lost), std::string::npos);
}

}  // namespace
}  // namespace geodesic
