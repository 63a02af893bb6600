// The library as used by programs that only need distances.
#include <geodesic/geodesic.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshes/oracles/random_meshes.h"
#include "meshes/row_solver.h"
#include "tests/message_of.h"

namespace geodesic {
namespace {

const TriangleSoup kSphere = rough_sphere(6, 2, 0.2);

/// Uses a separate file for each test, since tests may run at the same time.
SurfaceMesh read_sphere() {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto file = std::filesystem::path(testing::TempDir()) / ("geodesic_test_" + test + ".obj");
  const std::string bytes = mesh_bytes(kSphere, file);
  std::ofstream(file, std::ios::binary) << bytes;
  SurfaceMesh mesh = read_mesh(file);
  std::filesystem::remove(file);
  return mesh;
}

std::vector<double> all(const Field& field) {
  return {field.distances().begin(), field.distances().end()};
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SurfaceMesh, has_the_numbers_of_its_file_while_solvers_have_their_own) {
  const SurfaceMesh mesh = read_sphere();
  const Mesh& of_solvers = mesh;
  ASSERT_EQ(mesh.vertex_count(), kSphere.positions.size());
  EXPECT_EQ(mesh.face_count(), kSphere.triangles.size());
  EXPECT_EQ(mesh.soup().triangles, kSphere.triangles);
  int elsewhere = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(mesh.position(v), kSphere.positions[v]);
    EXPECT_EQ(position_of(mesh, v), kSphere.positions[v]);
    elsewhere += of_solvers.position(v) != kSphere.positions[v];
  }
  EXPECT_GT(elsewhere, 0);
}

TEST(SurfaceMesh, of_triangles_is_checked_as_that_of_a_file) {
  const TriangleSoup three_faces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                                 {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}};
  const std::string why = "1 non-manifold edge";
  EXPECT_NE(message_of<MeshError>([&] {
              SurfaceMesh(three_faces.positions, three_faces.triangles);
            }).find("the triangles: distances would be meaningless: " + why),
            std::string::npos);
  EXPECT_EQ(SurfaceMesh(three_faces, {.repair = true}).face_count(), 3u);
  const SurfaceMesh crossed(three_faces, {.non_manifold_edges = NonManifoldEdges::crossed});
  EXPECT_NEAR(DistanceSolver(crossed).from({2})[3], 2, 1e-12);
}

TEST(SurfaceMesh, without_a_face_is_refused_for_that_reason) {
  const std::string why = "the triangles: empty mesh: no faces";
  const TriangleSoup points{{{0, 0, 0}, {1, 0, 0}}, {}};
  EXPECT_EQ(message_of<MeshError>([] { SurfaceMesh{TriangleSoup{}}; }), why);
  EXPECT_EQ(message_of<MeshError>([&] { SurfaceMesh{points}; }), why);
  EXPECT_EQ(message_of<MeshError>([&] { SurfaceMesh(points, {.repair = true, .weld = 0}); }), why);
}

TEST(DistanceSolver, gives_the_bits_of_a_timed_solve_on_the_file_in_the_fast_numbering) {
  const SurfaceMesh mesh = read_sphere();
  for (const std::string name : {"edge-based", "mmp", "dijkstra"}) {
    std::vector<double> expected(mesh.vertex_count());
    make_solver(name, mesh)->solve({.sources = {{5}, {17}}, .limit = 1.5}, expected);
    DistanceSolver solver(mesh, name);
    EXPECT_EQ(all(solver.from({5, 17}, {.limit = 1.5})), expected) << name;
    EXPECT_EQ(all(solver.from(std::vector<Index>{5, 17}, {.limit = 1.5})), expected) << name;
  }
}

TEST(DistanceSolver, takes_initial_distances) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  const Field field = solver.from(std::vector<Source>{{.at = 5, .distance = 0.25}, {.at = 17}});
  EXPECT_EQ(field[17], 0);
  EXPECT_LE(field[5], 0.25);
  EXPECT_GT(field[5], 0);
}

TEST(DistanceSolver, takes_sources_in_any_list_of_vertices_points_and_sources) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  const SurfacePoint point = point_in_face(mesh, 7, {1, 2, 3});
  const std::vector<double> from_two = all(solver.from({5, 17}));
  EXPECT_EQ(all(solver.from(std::vector<int>{5, 17})), from_two);
  EXPECT_EQ(all(solver.from(std::vector<std::size_t>{5, 17})), from_two);
  EXPECT_EQ(all(solver.from({{.at = 5}, {.at = 17, .distance = 0}})), from_two);
  EXPECT_EQ(all(solver.from({Source{5, 0.}, Source{17, 0.}})), from_two);
  EXPECT_EQ(all(solver.from(point)), all(solver.from({point})));
  EXPECT_EQ(all(solver.from(5, {.limit = 1})), all(solver.from({5}, {.limit = 1})));
  EXPECT_EQ(all(solver.from({{point, 0.25}, {5, 0.5}})),
            all(solver.from(
                std::vector<Source>{{.at = point, .distance = 0.25}, {.at = 5, .distance = 0.5}})));
}

TEST(DistanceSolver, refuses_a_number_that_no_index_holds_instead_of_cutting_it_off) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  const std::string end =
      " is not in the mesh of " + std::to_string(mesh.vertex_count()) + " vertices";
  EXPECT_EQ(refusal([&] { solver.from(std::vector<int>{3, -1}); }), "source vertex -1" + end);
  EXPECT_EQ(refusal([&] { solver.from(std::vector<std::uint64_t>{1ull << 32}); }),
            "source vertex 4294967296" + end);
}

// A range whose `begin` is not const, as of std::views::filter.
TEST(DistanceSolver, takes_sources_from_a_filtered_range) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  const std::vector<Index> some{5, 6, 17, 18};
  const auto is_odd = [](Index v) { return v % 2 == 1; };
  EXPECT_EQ(all(solver.from(some | std::views::filter(is_odd))), all(solver.from({5, 17})));
}

// What refers to a temporary object does not compile: a range-based for loop would read it after
// its end.
template <class Of>
constexpr bool kLendsDistances = requires(Of&& of) {
  std::forward<Of>(of).distances();
};
template <class Of>
constexpr bool kLendsPositions = requires(Of&& of) {
  std::forward<Of>(of).positions();
};
template <class Of>
constexpr bool kLendsOutgoing = requires(Of&& of) {
  std::forward<Of>(of).outgoing(0);
};
template <class Of>
constexpr bool kLendsTargets = requires(Of&& of) {
  std::forward<Of>(of).at_targets();
};
template <class Of>
constexpr bool kLendsRow = requires(Of&& of) {
  std::forward<Of>(of).row();
};

static_assert(kLendsDistances<const Field&> && !kLendsDistances<Field> &&
              !kLendsDistances<const Field>);
static_assert(kLendsDistances<const Paths&> && !kLendsDistances<Paths> &&
              !kLendsDistances<const Paths>);
static_assert(kLendsDistances<RowSolver&> && !kLendsDistances<RowSolver>);
static_assert(kLendsTargets<RowSolver&> && !kLendsTargets<RowSolver>);
static_assert(kLendsRow<RowSolver&> && !kLendsRow<RowSolver>);
static_assert(kLendsPositions<const Mesh&> && !kLendsPositions<Mesh> &&
              !kLendsPositions<const Mesh>);
static_assert(kLendsOutgoing<const Mesh&> && !kLendsOutgoing<Mesh> && !kLendsOutgoing<const Mesh>);
static_assert(!std::is_reference_v<decltype(std::declval<SurfaceMesh>().position(0))>);
template <class From>
constexpr bool kSolvesOn = std::is_constructible_v<DistanceSolver, From>;
static_assert(kSolvesOn<const SurfaceMesh&> && kSolvesOn<SurfaceMesh>);  // shares the mesh
static_assert(std::is_nothrow_move_constructible_v<DistanceSolver> &&
              std::is_nothrow_move_assignable_v<DistanceSolver>);
static_assert(kSolvesOn<const Mesh&> && !kSolvesOn<Mesh> && !kSolvesOn<const Mesh>);

TEST(Field, has_the_numbers_of_the_file) {
  const SurfaceMesh mesh = read_sphere();
  const Vec3 middle = position_of(mesh, point_in_face(mesh, 7, {1, 1, 1}));
  const auto [a, b, c] = kSphere.triangles[7];
  for (std::size_t k = 0; k < 3; ++k) {
    const double sum = kSphere.positions[a][k] + kSphere.positions[b][k] + kSphere.positions[c][k];
    EXPECT_NEAR(middle[k], sum / 3, 1e-15);
  }
  const Field field = DistanceSolver(mesh).from({a});
  EXPECT_NEAR(field[b], norm(subtract(kSphere.positions[a], kSphere.positions[b])), 1e-15);
  EXPECT_EQ(field.at(b), field[b]);
  EXPECT_EQ(field.path_to(c).points.front().at, SurfacePoint(a));
}

TEST(Field, leads_to_vertices_and_points_by_paths_as_long_as_they_are_far) {
  const SurfaceMesh mesh = read_sphere();
  const SurfacePoint source = point_in_face(mesh, 7, {.2, .3, .5});
  const Field field = DistanceSolver(mesh).from({0, source});
  const std::vector<Index> nearest = field.nearest_sources();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Path path = field.path_to(v);
    EXPECT_NEAR(path.length(), field[v], 1e-12);
    EXPECT_EQ(path.source, field.nearest_source(v));
    EXPECT_EQ(path.source, nearest[v]);
    EXPECT_EQ(path.points.front().at, path.source == 0 ? SurfacePoint(0) : source);
  }
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const SurfacePoint point = point_in_face(mesh, face, {.1, .6, .3});
    const Path path = field.path_to(point);
    EXPECT_NEAR(path.length(), field.at(point), 1e-12);
    EXPECT_EQ(path.points.back().at, point);
  }
}

TEST(DistanceSolver, joins_the_paths_through_points) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  const double there = solver.from({3}).at(40), back = solver.from({40}).at(3);
  EXPECT_NEAR(solver.path_through({3, 40}).length(), there, 1e-12 * there);
  EXPECT_NEAR(solver.path_through({3, 40}, {.closed = true}).length(), there + back, 1e-12 * there);
  EXPECT_THROW(solver.path_through({3, 40}, {.closed = true, .straighten = true}),
               std::invalid_argument);
}

TEST(DistanceSolver, joins_the_paths_through_any_list_of_vertices_and_points) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  const double length = solver.path_through({3, 40, 7}).length();
  EXPECT_EQ(solver.path_through(std::vector<int>{3, 40, 7}).length(), length);
  EXPECT_EQ(solver.path_through(std::vector<std::size_t>{3, 40, 7}).length(), length);
  EXPECT_EQ(solver.path_through(std::vector<SurfacePoint>{3, 40, 7}).length(), length);
  EXPECT_EQ(refusal([&] {
              solver.path_through(std::vector<int>{3, -1});
            }),
            "vertex -1 is not in the mesh of " + std::to_string(mesh.vertex_count()) + " vertices");
}

TEST(Field, has_isolines_that_close_on_a_closed_surface) {
  const SurfaceMesh mesh = read_sphere();
  for (const char* solver : {"edge-based", "dijkstra"}) {
    const Field field = DistanceSolver(mesh, solver).from({0});
    const std::vector<Isoline> lines = field.isolines(field.levels(5));
    EXPECT_GE(lines.size(), 5u);
    for (const Isoline& line : lines) EXPECT_TRUE(line.closed);
    EXPECT_EQ(refusal([&] {
                field.isolines({1, -1});
              }),
              "the level of an isoline must be a finite distance above 0, not -1");
  }
}

TEST(Field, is_as_far_at_points_as_a_solve_from_there_says) {
  const SurfaceMesh mesh = read_sphere();
  const auto [a, b, c] = kSphere.triangles[100];
  const SurfacePoint point = point_on_edge(mesh, a, b, .25);
  const std::vector<double> expected = all(DistanceSolver(mesh).from({point}));
  for (const Index v : {0u, 33u, 90u, c}) {
    EXPECT_NEAR(DistanceSolver(mesh).from({v}).at(point), expected[v], 1e-12);
  }
}

// Its coordinates in a frame at another corner have lost the digits of the distance.
TEST(Field, has_all_digits_of_the_distance_at_a_point_next_to_a_source) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    const auto beside = [&](double along, double up) {
      std::array<double, 3> weights{};
      weights[k] = 1;
      weights[l] = along;
      weights[m] = up;
      return point_in_face(mesh, 7, weights);
    };
    const auto from_corner = [&](const SurfacePoint& point) {
      const Triangle& t = kSphere.triangles[7];
      const Vec3& corner = kSphere.positions[t[k]];
      return add(scale(point.weights[l], subtract(kSphere.positions[t[l]], corner)),
                 scale(point.weights[m], subtract(kSphere.positions[t[m]], corner)));
    };
    const SurfacePoint point = beside(3e-10, 4e-10), source = beside(0, 1e-9);
    const double from_source = norm(subtract(from_corner(point), from_corner(source)));
    const double to_corner = norm(from_corner(point));
    for (const bool anywhere : {false, true}) {
      EXPECT_NEAR(solver.from(source, {.anywhere = anywhere}).at(point), from_source,
                  1e-12 * from_source);
      EXPECT_NEAR(solver.from(kSphere.triangles[7][k], {.anywhere = anywhere}).at(point), to_corner,
                  1e-12 * to_corner);
    }
  }
}

TEST(Field, has_one_gradient_at_both_ends_of_an_edge_without_length) {
  TriangleSoup soup = kSphere;
  const auto [a, b, c] = soup.triangles[100];
  soup.positions[b] = soup.positions[a];
  const SurfaceMesh mesh(soup);
  for (const Index source : {0u, 40u, c}) {
    const Field field = DistanceSolver(mesh).from({source});
    const Vec3 gradient = field.gradient(a);
    EXPECT_NEAR(norm(gradient), 1, 1e-12);
    EXPECT_NEAR(norm(subtract(field.gradient(b), gradient)), 0, 1e-12);
  }
  EXPECT_TRUE(std::isnan(DistanceSolver(mesh).from({a}).gradient(b)[0]));
}

// Points become vertices: the graph of edges has no vertices inside faces.
TEST(Field, is_asked_of_any_points_by_solvers_that_know_vertices_only) {
  const SurfaceMesh mesh = read_sphere();
  const SurfacePoint point = point_in_face(mesh, 7, {.2, .3, .5});
  const Index corner = kSphere.triangles[7][0];
  const double line = norm(subtract(position_of(mesh, point), kSphere.positions[corner]));
  DistanceSolver dijkstra(mesh, "dijkstra");
  EXPECT_NEAR(dijkstra.from({point})[corner], line, 1e-12);
  EXPECT_NEAR(dijkstra.from({corner}).at(point), line, 1e-12);
}

TEST(Field, has_the_same_distances_at_several_points_as_at_each) {
  const SurfaceMesh mesh = read_sphere();
  const std::vector<SurfacePoint> points = {point_in_face(mesh, 7, {.2, .3, .5}), 12,
                                            point_in_face(mesh, 90, {1, 1, 1})};
  for (const char* solver : {"edge-based", "dijkstra"}) {
    const Field field = DistanceSolver(mesh, solver).from({0, points[2]});
    const std::vector<double> together = field.at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(together[i], field.at(points[i]), 1e-12) << solver << ' ' << i;
    }
    EXPECT_TRUE(field.at(std::vector<SurfacePoint>{}).empty());
  }
}

TEST(Field, outlives_its_solver_and_is_copied) {
  const SurfaceMesh mesh = read_sphere();
  Field field = DistanceSolver(mesh).from({0});
  const Field copy = field;
  field = DistanceSolver(mesh).from({1});
  EXPECT_EQ(copy[0], 0);
  EXPECT_EQ(field[1], 0);
}

struct MeshAndSolver {
  SurfaceMesh mesh = read_sphere();
  DistanceSolver solver{mesh};
};

TEST(DistanceSolver, is_moved_with_its_mesh) {
  MeshAndSolver first;
  const std::vector<double> expected = all(first.solver.from({5}));
  MeshAndSolver moved = std::move(first);
  EXPECT_EQ(all(moved.solver.from({5})), expected);
  moved = MeshAndSolver();
  EXPECT_EQ(all(moved.solver.from({5})), expected);
}

TEST(Field, outlives_its_mesh) {
  for (const char* solver : {"edge-based", "dijkstra"}) {
    const Field field = [&] {
      const SurfaceMesh mesh = read_sphere();
      return DistanceSolver(mesh, solver).from({0});
    }();
    const SurfaceMesh mesh = read_sphere();
    const SurfacePoint point = point_in_face(mesh, 7, {.2, .3, .5});
    EXPECT_EQ(field.at(point), DistanceSolver(mesh, solver).from({0}).at(point)) << solver;
    EXPECT_FALSE(field.isolines(field.levels(3)).empty());
  }
}

TEST(Field, has_no_paths_beyond_the_limit) {
  const SurfaceMesh mesh = read_sphere();
  const Field field = DistanceSolver(mesh).from({0}, {.limit = 1e-9});
  EXPECT_EQ(field[50], kInfinity);
  EXPECT_EQ(field.nearest_source(50), kNone);
  EXPECT_EQ(refusal([&] { field.path_to(50); }), "no path leads to vertex 50");
  EXPECT_FALSE(field.find_path_to(50));
  EXPECT_TRUE(field.find_path_to(0));
  Index face = 0;
  while (kSphere.triangles[face][0] != 50) ++face;
  const SurfacePoint beyond = point_in_face(mesh, face, {.2, .3, .5});
  EXPECT_EQ(field.at(beyond), kInfinity);
  EXPECT_FALSE(field.find_path_to(beyond));
  EXPECT_EQ(refusal([&] { field.path_to(beyond); }),
            "no path leads to the point in face " + std::to_string(face));
}

TEST(DistanceSolver, says_in_one_line_what_it_cannot_do) {
  const SurfaceMesh mesh = read_sphere();
  DistanceSolver solver(mesh), dijkstra(mesh, "dijkstra");
  const Field field = solver.from({0}), without_paths = dijkstra.from({0});
  const std::string many = std::to_string(mesh.vertex_count());
  const std::string missing = "vertex 9999 is not in the mesh of " + many + " vertices";
  const std::string no_paths =
      "dijkstra does not remember paths: take another solver, such as edge-based";
  EXPECT_EQ(refusal([&] { without_paths.path_to(3); }), no_paths);
  EXPECT_EQ(refusal([&] { without_paths.nearest_source(3); }), no_paths);
  EXPECT_EQ(refusal([&] { field.at(9999); }), missing);
  EXPECT_EQ(refusal([&] { without_paths.at(9999); }), missing);
  EXPECT_EQ(refusal([&] { field.path_to(9999); }), missing);
  EXPECT_NE(refusal([&] { solver.from({9999}); }).find(missing), std::string::npos);
  for (const auto& call : std::vector<std::function<void()>>{
           [&] { solver.from(std::vector<Index>{}); },
           [&] { solver.from({0}, {.limit = -1}); },
           [&] { DistanceSolver(mesh, "no-such-solver"); },
           [&] { solver.from({{.at = 0, .distance = -1}}); },
           [&] { solver.from({SurfacePoint()}); },
           [&] { position_of(mesh, SurfacePoint()); },
           [&] { position_of(mesh, 9999); },
       }) {
    const std::string line = refusal(call);
    EXPECT_NE(line, "");
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace geodesic
