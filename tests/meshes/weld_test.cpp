// A welded mesh has the distances of the mesh that it was before it was cut, in the numbers of the
// input.
#include "meshes/weld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>

#include "geodesic/geodesic.h"
#include "meshes/nearest_point.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/core/prepared_file.h"
#include "tests/message_of.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

constexpr double kRelative = 1e-12;

void expect_close(const std::vector<double>& got, const std::vector<double>& expected,
                  const std::string& what) {
  ASSERT_EQ(got.size(), expected.size()) << what;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (got[i] != expected[i]) {
      EXPECT_NEAR(got[i], expected[i], kRelative * expected[i]) << what << ", vertex " << i;
    }
  }
}

struct Cut {
  TriangleSoup whole, cut;
  std::vector<Index> original;  // by vertex of the cut mesh: that of the whole one

  // Distances of the whole mesh's vertices, by vertex of the cut mesh.
  std::vector<double> spread(const std::vector<double>& distances) const {
    std::vector<double> all;
    for (const Index v : original) all.push_back(distances[v]);
    return all;
  }
};

/// The plane rectangle from (0, 0) to (2, 1), cut at x = 1: the right plate gets its own vertices
/// there, which are the last ones.
Cut two_plates() {
  Cut plates;
  constexpr Index kColumns = 8, kRows = 5;
  for (Index x = 0; x <= kColumns; ++x) {
    for (Index y = 0; y <= kRows; ++y) {
      plates.original.push_back(static_cast<Index>(plates.whole.positions.size()));
      plates.whole.positions.push_back({2.0 * x / kColumns, 1.0 * y / kRows, 0});
    }
  }
  for (Index x = 0; x < kColumns; ++x) {
    for (Index y = 0; y < kRows; ++y) {
      const Index a = x * (kRows + 1) + y, b = a + kRows + 1;
      plates.whole.triangles.push_back({a, b, b + 1});
      plates.whole.triangles.push_back({a, b + 1, a + 1});
    }
  }
  plates.cut = plates.whole;
  std::vector<Index> copies(plates.whole.positions.size(), kNone);
  for (std::size_t f = plates.cut.triangles.size() / 2; f < plates.cut.triangles.size(); ++f) {
    for (Index& v : plates.cut.triangles[f]) {
      const Vec3 at = plates.whole.positions[v];
      if (at[0] != 1) continue;
      if (copies[v] == kNone) {
        copies[v] = static_cast<Index>(plates.cut.positions.size());
        plates.cut.positions.push_back(at);
        plates.original.push_back(v);
      }
      v = copies[v];
    }
  }
  return plates;
}

/// A globe of rows and columns as textures need it: the first meridian has its vertices twice, and
/// each pole has one a column, so that one triangle of each square there has no area.
Cut globe(Index columns, Index rows) {
  Cut globe;
  const auto in_whole = [&](Index x, Index y) -> Index {
    if (y == 0) return 0;
    return y == rows ? 1 : 2 + (y - 1) * columns + x % columns;
  };
  globe.whole.positions.resize(2 + std::size_t{rows - 1} * columns);
  for (Index x = 0; x <= columns; ++x) {
    for (Index y = 0; y <= rows; ++y) {
      const double along = 2 * std::numbers::pi * (x % columns) / columns;
      const double down = std::numbers::pi * y / rows;
      const double across = y == 0 || y == rows ? 0 : std::sin(down);
      const Vec3 at = {across * std::cos(along), across * std::sin(along), std::cos(down)};
      globe.original.push_back(in_whole(x, y));
      globe.whole.positions[in_whole(x, y)] = at;
      globe.cut.positions.push_back(at);
    }
  }
  for (Index x = 0; x < columns; ++x) {
    for (Index y = 0; y < rows; ++y) {
      const Index a = x * (rows + 1) + y, b = a + rows + 1;
      globe.cut.triangles.push_back({a, a + 1, b + 1});
      globe.cut.triangles.push_back({a, b + 1, b});
    }
  }
  for (Triangle face : globe.cut.triangles) {
    for (Index& v : face) v = globe.original[v];
    if (!names_a_vertex_twice(face)) globe.whole.triangles.push_back(face);
  }
  return globe;
}

std::size_t infinite_among(const std::vector<double>& distances) {
  return static_cast<std::size_t>(std::ranges::count(distances, kInfinity));
}

TEST(Weld, two_plates_that_share_an_edge_of_doubled_vertices_are_one_plane) {
  const Cut plates = two_plates();
  TriangleSoup soup = plates.cut;
  ASSERT_EQ(weld(soup).size(), 1u);
  const auto copy = static_cast<Index>(soup.joined_to.size() - 1);
  const Index original = plates.original[copy];
  for (const Numbering numbering : {Numbering::as_given, Numbering::along_surface}) {
    const Mesh whole(plates.whole, numbering), welded(soup, numbering);
    EXPECT_EQ(infinite_among(distances_by("mmp", Mesh(plates.cut, numbering), {.sources = {{0}}})),
              plates.cut.positions.size() / 2);
    for (const std::string solver : {"edge-based", "mmp", "ich", "dijkstra", "straight-graph"}) {
      const bool exact = solver_named(solver).exactness == Exactness::exact;
      for (const Index source : {Index{0}, original, copy}) {
        const auto got = distances_by(solver, welded, {.sources = {{source}}});
        const Query query{.sources = {{plates.original[source]}}};
        EXPECT_EQ(got, plates.spread(distances_by(solver, whole, query))) << solver;
        for (Index v = 0; exact && v < got.size(); ++v) {
          const double line = norm(subtract(soup.positions[v], soup.positions[source]));
          EXPECT_NEAR(got[v], line, kRelative * line) << solver << ' ' << source << ' ' << v;
        }
      }
    }
  }
}

TEST(Weld, both_names_of_a_vertex_give_the_same_answers_of_every_kind) {
  const Cut plates = two_plates();
  const SurfaceMesh mesh(plates.cut, {.weld = 0}),
      whole(plates.whole.positions, plates.whole.triangles);
  const Index copy = mesh.vertex_count() - 1, original = plates.original[copy];
  const SurfacePoint inside = point_in_face(mesh, 71, {0.2, 0.3, 0.5});
  const std::vector<double> ends = {norm(subtract(position_of(mesh, inside), mesh.position(copy)))};
  for (const std::string solver : {"edge-based", "ich", "dijkstra", "straight-graph"}) {
    const std::vector<PointPair> pairs = {
        {original, inside}, {copy, inside}, {inside, copy}, {copy, original}};
    const std::vector<double> got = pair_distances(mesh, pairs, solver);
    EXPECT_EQ(got[0], got[1]) << solver;
    EXPECT_EQ(got[3], 0) << solver;
    if (solver == "dijkstra") continue;
    const double error = solver == "straight-graph" ? 0.1 : kRelative;
    EXPECT_NEAR(got[0], ends[0], error) << solver;
    EXPECT_NEAR(got[2], ends[0], error) << solver;
  }
  DistanceSolver of_mesh(mesh), of_whole(whole);
  const Field field = of_mesh.from({copy, 0}), expected = of_whole.from({original, 0});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(field.nearest_source(v), expected.nearest_source(plates.original[v]));
  }
  EXPECT_EQ(field.at(inside), expected.at(inside));
  EXPECT_EQ(field.path_to(copy).points.size(), 1u);
  const auto lines = field.isolines({0.3, 0.7}), others = expected.isolines({0.3, 0.7});
  ASSERT_EQ(lines.size(), others.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_EQ(lines[i].points.size(), others[i].points.size());
    for (std::size_t k = 0; k < lines[i].points.size(); ++k) {
      EXPECT_EQ(lines[i].points[k].face, others[i].points[k].face);
      EXPECT_EQ(lines[i].points[k].position, others[i].points[k].position);
    }
  }
  const Path path = of_mesh.from({0}).path_to(inside);
  EXPECT_NEAR(path.length(), norm(position_of(mesh, inside)), kRelative);
}

TEST(Weld, a_preparation_of_a_welded_mesh_is_read_again) {
  const SurfaceMesh mesh(two_plates().cut, {.weld = 0});
  const auto solver = make_solver("straight-graph", mesh);
  std::stringstream file;
  save_prepared(*solver, file);
  std::vector<double> first(mesh.vertex_count()), second(mesh.vertex_count());
  const Query query{.sources = {{mesh.vertex_count() - 1}}};
  solver->solve(query, first);
  read_prepared(mesh, file)->solve(query, second);
  EXPECT_EQ(first, second);
  EXPECT_EQ(infinite_among(first), 0u);
}

TEST(Weld, a_globe_with_a_doubled_meridian_and_poles_is_the_closed_globe) {
  const Cut given = globe(12, 7);
  const SurfaceMesh mesh(given.cut, {.weld = 0});
  const Mesh whole(given.whole);
  EXPECT_EQ(mesh.soup().left_out.size(), given.cut.triangles.size());
  for (Index source = 0; source < mesh.vertex_count(); source += 13) {
    const Query query{.sources = {{given.original[source]}}};
    const auto expected = given.spread(distances_by("mmp", whole, query));
    for (const std::string solver : {"edge-based", "mmp", "ich"}) {
      expect_close(distances_by(solver, mesh, {.sources = {{source}}}), expected, solver);
    }
    expect_close(BruteForce(mesh).distances(std::vector<Source>{{source}}), expected,
                 "brute force");
  }
  EXPECT_EQ(distances_by("mmp", mesh, {.sources = {{0}}})[12 * 8], 0);
}

TEST(Weld, faces_keep_the_numbers_of_the_input_and_one_that_collapsed_has_no_points) {
  const Cut given = globe(12, 7);
  const SurfaceMesh mesh(given.cut, {.weld = 0});
  EXPECT_EQ(mesh.face_count(), given.cut.triangles.size());
  const TriangleSoup soup = mesh.soup();
  std::size_t left_out = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!soup.is_face(f)) {
      ++left_out;
      EXPECT_EQ(message_of<std::invalid_argument>([&] {
                  point_in_face(mesh, f, {1, 1, 1});
                }),
                "face " + std::to_string(f) +
                    " collapsed when vertices were joined, or is avoided; name a vertex of it, or "
                    "a point in another face");
      continue;
    }
    Vec3 middle{};
    for (const Index v : given.cut.triangles[f]) {
      middle = add(middle, scale(1.0 / 3, given.cut.positions[v]));
    }
    const SurfacePoint point = point_in_face(mesh, f, {1, 1, 1});
    EXPECT_EQ(point.face, f);
    EXPECT_NEAR(norm(subtract(position_of(mesh, point), middle)), 0, kRelative);
  }
  EXPECT_EQ(left_out, 24u);
  // A finer mesh, for a solver that takes vertices only, has the points as vertices.
  const SurfacePoint a = point_in_face(mesh, 2, {1, 1, 2}), b = point_in_face(mesh, 150, {1, 2, 1});
  const InsertedPoints inserted(mesh, std::vector{a, b});
  std::vector<double> finer =
      distances_by("mmp", inserted.mesh(), inserted.translated({.sources = {{a}}, .targets = {b}}));
  EXPECT_NEAR(finer[inserted.vertex(b)], pair_distances(mesh, std::vector<PointPair>{{a, b}})[0],
              1e-10);
  finer.resize(mesh.vertex_count());
  EXPECT_EQ(finer.front(), finer[8]) << "two names of the pole";
  EXPECT_EQ(infinite_among(finer), 0u);
  const SurfacePoint found = NearestPointSearch(mesh).nearest_to(position_of(mesh, b)).at;
  EXPECT_EQ(found.face, b.face);
}

TEST(Weld, a_soup_of_triangles_in_floats_is_the_surface_within_a_distance) {
  const TriangleSoup whole = rough_sphere(3, 2, 0.2);
  std::mt19937 random(1);
  Cut exploded;
  std::vector<Vec3> first(whole.positions.size());
  std::vector<bool> seen(whole.positions.size(), false);
  for (const Triangle& face : whole.triangles) {
    Triangle corners;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 at = whole.positions[face[k]];
      for (double& c : at) {  // the float above or below
        const auto rounded = static_cast<float>(c);
        c = random() % 2 == 0 ? rounded : std::nextafter(rounded, 9.0f);
      }
      corners[k] = static_cast<Index>(exploded.cut.positions.size());
      exploded.cut.positions.push_back(at);
      exploded.original.push_back(face[k]);
      if (!seen[face[k]]) first[face[k]] = at;
      seen[face[k]] = true;
    }
    exploded.cut.triangles.push_back(corners);
  }
  const SurfaceMesh mesh(exploded.cut, {.weld = 1e-5});
  const Mesh rounded(first, whole.triangles);
  for (const Index source : {0u, 100u, 500u}) {
    const Query query{.sources = {{exploded.original[source]}}};
    expect_close(distances_by("edge-based", mesh, {.sources = {{source}}}),
                 exploded.spread(distances_by("edge-based", rounded, query)), "soup");
  }
  TriangleSoup exactly = exploded.cut;
  weld(exactly, 0);
  EXPECT_LT(find_defects(exactly).count(DefectKind::several_components), whole.triangles.size());
  EXPECT_GT(find_defects(exactly).count(DefectKind::several_components), 1u);
}

TEST(Weld, joins_a_chain_in_steps_of_the_distance_and_nothing_farther) {
  TriangleSoup soup;  // triangles whose first corners are 1 apart, in rows 1.001 apart
  for (const double y : {0.0, 1.001, -3.0}) {
    for (int x = -3; x < 4; ++x) {
      const auto v = static_cast<Index>(soup.positions.size());
      soup.positions.push_back({1.0 * x, y, 0});
      soup.positions.push_back({100.0 * x, y, 100});
      soup.positions.push_back({100.0 * x, y, -100});
      soup.triangles.push_back({v, v + 1, v + 2});
    }
  }
  TriangleSoup near = soup, nearer = soup, all = soup;
  EXPECT_TRUE(weld(nearer, 0.999).empty());
  EXPECT_TRUE(nearer.joined_to.empty());
  const auto done = weld(near, 1);
  ASSERT_EQ(done.size(), 1u);
  EXPECT_EQ(done[0].summary(), "vertices joined to an earlier one: 18");
  for (const Index row : {0u, 21u, 42u}) {
    for (Index v = row; v < row + 21; v += 3) EXPECT_EQ(near.joined_to[v], row);
  }
  EXPECT_TRUE(weld(near, 1).empty()) << "a second weld joined more";
  EXPECT_EQ(weld(all, 1e6).back().count, soup.triangles.size());  // collapsed
}

TEST(Weld, finds_the_same_pairs_as_a_comparison_of_all_vertices) {
  std::mt19937 random(5);
  for (const double distance : {0.0, 0.01, 0.1, 0.5}) {
    for (int round = 0; round < 20; ++round) {
      TriangleSoup soup;
      std::uniform_real_distribution<double> place(-1, 1);
      for (Index v = 0; v < 120; ++v) {
        const Vec3 at = {place(random), place(random), v % 2 == 0 ? 0.0 : -0.0};
        soup.positions.push_back(v > 0 && v % 3 == 0 ? soup.positions[random() % v] : at);
      }
      for (Index v = 0; v < 120; v += 3) soup.triangles.push_back({v, v + 1, v + 2});
      DisjointSets sets(120);
      for (Index a = 0; a < 120; ++a) {
        for (Index b = 0; b < a; ++b) {
          if (norm(subtract(soup.positions[a], soup.positions[b])) <= distance) sets.join(a, b);
        }
      }
      weld(soup, distance);
      ASSERT_EQ(soup.joined_to.size(), 120u);
      for (Index v = 0; v < 120; ++v) ASSERT_EQ(soup.joined_to[v], sets.find(v)) << distance;
    }
  }
}

TEST(Weld, takes_a_distance_only) {
  for (const double distance : {-1.0, -1e-300, kInfinity, std::nan("")}) {
    TriangleSoup soup = two_plates().cut;
    EXPECT_TRUE(message_of<std::invalid_argument>([&] { weld(soup, distance); })
                    .starts_with("the distance within which vertices are joined must be finite "
                                 "and 0 or more, not "));
  }
  TriangleSoup soup = two_plates().cut;
  EXPECT_FALSE(weld(soup, std::numeric_limits<double>::denorm_min()).empty());
}

TEST(Weld, leaves_faces_that_are_defects_as_they_are) {
  TriangleSoup soup = two_plates().cut;
  soup.triangles.insert(soup.triangles.end(), {{0, 0, 1}, {kNone, 0, 1}, {kNone, kNone, kNone}});
  soup.positions.push_back({std::nan(""), 0, 0});
  soup.positions.push_back(soup.positions[0]);  // isolated
  weld(soup, 0);
  const DefectReport found = find_defects(soup);
  EXPECT_EQ(found.count(DefectKind::repeated_vertex), 1u);
  EXPECT_EQ(found.count(DefectKind::index_out_of_range), 2u);
  EXPECT_EQ(found.count(DefectKind::isolated_vertex), 2u);
  repair(soup);
  EXPECT_EQ(infinite_among(distances_by("mmp", Mesh(soup), {.sources = {{0}}})), 2u);
}

}  // namespace
}  // namespace geodesic
