// Distances with avoided vertices and faces are those of the mesh without these faces, in the
// numbers of the input.
#include "meshes/avoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "geodesic/geodesic.h"
#include "meshes/nearest_point.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/summary.h"
#include "tests/message_of.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

constexpr double kRounding = 1e-12;
constexpr Index kPlateColumns = 9, kPlateRows = 7;
constexpr double kLeft = 3, kRight = 6, kBottom = 2, kTop = 5;  // of the avoided rectangle

Index vertex_at(double x, double y) { return static_cast<Index>(x * (kPlateRows + 1) + y); }

/// The plane rectangle from (0, 0) to (9, 7), of unit squares.
TriangleSoup plate() {
  TriangleSoup soup;
  for (Index x = 0; x <= kPlateColumns; ++x) {
    for (Index y = 0; y <= kPlateRows; ++y) soup.positions.push_back({1.0 * x, 1.0 * y, 0});
  }
  for (Index x = 0; x < kPlateColumns; ++x) {
    for (Index y = 0; y < kPlateRows; ++y) {
      const Index a = vertex_at(x, y), b = vertex_at(x + 1, y);
      soup.triangles.push_back({a, b, b + 1});
      soup.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return soup;
}

bool is_inside(const Vec3& p) {
  return p[0] > kLeft && p[0] < kRight && p[1] > kBottom && p[1] < kTop;
}

/// The faces of the rectangle.
std::vector<Index> rectangle(const TriangleSoup& soup) {
  std::vector<Index> faces;
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    Vec3 middle{};
    for (const Index v : soup.triangles[f]) {
      middle = add(middle, scale(1.0 / 3, soup.positions[v]));
    }
    if (is_inside(middle)) faces.push_back(f);
  }
  return faces;
}

TriangleSoup without_rectangle() {
  TriangleSoup soup = plate();
  leave_out(soup, {.faces = rectangle(soup)});
  return soup;
}

/// The same surface, of a file that never had these faces.
TriangleSoup with_hole() {
  TriangleSoup soup = plate();
  std::vector<bool> dropped(soup.triangles.size(), false);
  for (const Index f : rectangle(soup)) dropped[f] = true;
  drop_faces(soup, dropped);
  return soup;
}

/// Length of the straight line between two points, infinite if it crosses the rectangle.
double straight(const Vec3& a, const Vec3& b) {
  double begin = 0, end = 1;  // the part of the line that is within the sides
  const auto clip = [&](double from, double to, double low, double high) {
    if (from == to) {
      if (from <= low || from >= high) end = -1;
      return;
    }
    const double s = (low - from) / (to - from), t = (high - from) / (to - from);
    begin = std::max(begin, std::min(s, t));
    end = std::min(end, std::max(s, t));
  };
  clip(a[0], b[0], kLeft, kRight);
  clip(a[1], b[1], kBottom, kTop);
  return begin + 1e-12 < end ? kInfinity : norm(subtract(a, b));
}

/// The length of the shortest path around the rectangle: it bends at up to two of its corners.
double around(const Vec3& a, const Vec3& b) {
  const std::array<Vec3, 4> corners = {
      {{kLeft, kBottom, 0}, {kRight, kBottom, 0}, {kRight, kTop, 0}, {kLeft, kTop, 0}}};
  double least = straight(a, b);
  for (const Vec3& p : corners) {
    for (const Vec3& q : corners) {
      least = std::min(least, straight(a, p) + straight(p, q) + straight(q, b));
    }
  }
  return least;
}

TEST(Avoid, distances_lead_around_an_avoided_rectangle_and_are_the_bits_of_the_mesh_without_it) {
  const TriangleSoup avoided = without_rectangle(), hole = with_hole();
  for (const Numbering numbering : {Numbering::as_given, Numbering::along_surface}) {
    const Mesh mesh(avoided, numbering), same(hole, numbering);
    for (const std::string solver : {"edge-based", "mmp", "ich", "dijkstra", "straight-graph"}) {
      for (const auto& [x, y] : {std::pair(1, 3), std::pair(4, 7), std::pair(3, 2)}) {
        const Query query{.sources = {{vertex_at(x, y)}}};
        const auto got = distances_by(solver, mesh, query);
        EXPECT_EQ(got, distances_by(solver, same, query)) << solver;
        if (solver_named(solver).exactness != Exactness::exact) continue;
        for (Index v = 0; v < got.size(); ++v) {
          const Vec3& at = avoided.positions[v];
          const double expected = is_inside(at) ? kInfinity : around({1.0 * x, 1.0 * y, 0}, at);
          if (got[v] == expected) continue;
          EXPECT_NEAR(got[v], expected, kRounding * expected) << solver << ' ' << v;
        }
      }
    }
  }
  const Mesh mesh(avoided);
  const auto brute = BruteForce(mesh).distances(std::vector<Source>{{vertex_at(1, 3)}});
  EXPECT_NEAR(brute[vertex_at(8, 4)], around({1, 3, 0}, {8, 4, 0}), 1e-11);
}

TEST(Avoid, a_vertex_stands_for_all_its_faces_and_a_mask_for_its_numbers) {
  const TriangleSoup whole = plate();
  Avoided by_vertices, by_faces;
  for (Index v = 0; v < whole.positions.size(); ++v) {
    if (is_inside(whole.positions[v])) by_vertices.vertices.push_back(v);
  }
  for (Index f = 0; f < whole.triangles.size(); ++f) {
    if (std::ranges::any_of(whole.triangles[f],
                            [&](Index v) { return is_inside(whole.positions[v]); })) {
      by_faces.faces.push_back(f);
    }
  }
  Avoided flagged = by_vertices, both = by_faces;
  flagged.vertex_flags = whole.positions.size();
  flagged.face_flags = whole.triangles.size();
  both.vertices = by_vertices.vertices;
  TriangleSoup expected = whole;
  leave_out(expected, by_faces);
  EXPECT_EQ(std::ranges::count(expected.left_out, true), std::ssize(by_faces.faces));
  for (const Avoided& avoided : {by_vertices, flagged, both}) {
    TriangleSoup soup = whole;
    leave_out(soup, avoided);
    EXPECT_EQ(soup.left_out, expected.left_out);
    EXPECT_EQ(soup.triangles, whole.triangles);
    leave_out(soup, {});
    EXPECT_EQ(soup.left_out, expected.left_out);
  }
  TriangleSoup nothing = whole;
  leave_out(nothing, {.vertices = {}, .faces = {}, .vertex_flags = whole.positions.size()});
  EXPECT_TRUE(nothing.left_out.empty());
}

TEST(Avoid, either_name_of_a_joined_vertex_stands_for_the_faces_of_both) {
  const TriangleSoup plates = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}},
      {{0, 1, 2}, {3, 5, 4}, {5, 6, 4}}};
  for (const Index name : {1u, 3u}) {
    TriangleSoup soup = plates;
    weld(soup);
    leave_out(soup, {.vertices = {name}});
    EXPECT_EQ(soup.left_out, (std::vector<bool>{true, true, false})) << name;
  }
  TriangleSoup soup = plates;
  leave_out(soup, {.vertices = {3}});
  EXPECT_EQ(soup.left_out, (std::vector<bool>{false, true, false}));
}

TEST(Avoid, a_vertex_without_another_face_is_reached_from_itself_only) {
  const Mesh mesh(without_rectangle(), Numbering::along_surface);
  const Index inside = vertex_at(4, 3);
  for (const std::string solver : {"edge-based", "mmp", "dijkstra", "straight-graph"}) {
    const auto got = distances_by(solver, mesh, {.sources = {{inside}}});
    EXPECT_EQ(got[inside], 0) << solver;
    EXPECT_EQ(std::ranges::count(got, kInfinity), std::ssize(got) - 1) << solver;
  }
}

TEST(Avoid, paths_isolines_and_places_are_outside_of_avoided_faces_and_faces_keep_their_numbers) {
  const TriangleSoup whole = plate();
  const std::vector<Index> faces = rectangle(whole);
  const SurfaceMesh mesh(whole, {.avoid = {.faces = faces}});
  const auto is_avoided = [&](Index f) { return std::ranges::count(faces, f) > 0; };
  EXPECT_EQ(mesh.face_count(), whole.triangles.size());
  DistanceSolver solver(mesh);
  const Field field = solver.from({point_in_face(mesh, 0, {1, 1, 1}), vertex_at(9, 0)});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (is_inside(whole.positions[v])) continue;
    for (const PathPoint& point : field.path_to(v).points) {
      EXPECT_FALSE(is_inside(point.position));
      EXPECT_FALSE(point.face != kNone && is_avoided(point.face));
    }
  }
  for (const Isoline& line : field.isolines(field.levels(5))) {
    for (const auto& point : line.points) {
      EXPECT_FALSE(point.face != kNone && is_avoided(point.face));
    }
  }
  const NearestPoint nearest = NearestPointSearch(mesh).nearest_to({3.25, 3.4, 0});
  EXPECT_EQ(nearest.distance, 0.25);
  EXPECT_NEAR(norm(subtract(position_of(mesh, nearest.at), {3, 3.4, 0})), 0, kRounding);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto middle = [&] { return point_in_face(mesh, f, {1, 1, 1}); };
    if (is_avoided(f)) {
      EXPECT_EQ(message_of<std::invalid_argument>(middle),
                "face " + std::to_string(f) + " is avoided; name a point in another face");
    } else {
      EXPECT_EQ(middle().face, f);
    }
  }
  const auto middles = [](const Mesh& of, Index a, Index b) {
    return std::vector<PointPair>{
        {point_in_face(of, a, {1, 1, 1}), point_in_face(of, b, {1, 1, 1})}};
  };
  const auto pair = middles(mesh, 10, 115);
  const double expected = around(position_of(mesh, pair[0].from), position_of(mesh, pair[0].to));
  EXPECT_NEAR(pair_distances(mesh, pair)[0], expected, kRounding * expected);
  // A solver that takes vertices only, on a finer mesh.
  const TriangleSoup hole = with_hole();
  const SurfaceMesh same(hole.positions, hole.triangles);
  const auto same_pair = middles(same, 10, 115 - static_cast<Index>(faces.size()));
  EXPECT_EQ(pair_distances(mesh, pair, "virtual-source"),
            pair_distances(same, same_pair, "virtual-source"));
}

TEST(Avoid, a_vertex_of_avoided_faces_is_no_defect) {
  TriangleSoup soup = plate();
  soup.positions.push_back({1, 1, 1});  // isolated
  leave_out(soup, {.faces = rectangle(soup)});
  const DefectReport found = find_defects(soup);
  ASSERT_EQ(found.defects.size(), 1u);
  EXPECT_EQ(found.defects[0].text(), "1 isolated vertex (first: vertex 80)");
  const MeshSummary summary = summarize(soup);
  EXPECT_EQ(summary.isolated_vertices, 1u);
  EXPECT_EQ(summary.left_out_faces, 18u);
  EXPECT_EQ(summary.boundary_loops, 2u);
}

TEST(Avoid, refuses_what_the_mesh_does_not_have_and_a_list_that_seems_to_be_a_mask) {
  const auto message = [](const Avoided& avoided) {
    TriangleSoup soup = plate();
    const std::string text = message_of<std::invalid_argument>([&] { leave_out(soup, avoided); });
    return text;
  };
  EXPECT_EQ(message({.vertices = {0, 80}}), "avoided vertex 80 is not in the mesh of 80 vertices");
  EXPECT_EQ(message({.faces = {126, kNone}}), "avoided face 126 is not in the mesh of 126 faces");
  EXPECT_EQ(message({.vertices = {0}, .vertex_flags = 126}),
            "the mask of avoided vertices has 126 flags, but the mesh has 80 vertices");
  EXPECT_EQ(message({.face_flags = 125}),
            "the mask of avoided faces has 125 flags, but the mesh has 126 faces");
  EXPECT_EQ(message({.faces = {0, 1, 1, 0}}),
            "the list of avoided faces has only the numbers 0 and 1, and repeats them: it must "
            "name faces; only a mask of booleans has a flag for each of them");
  EXPECT_EQ(message({.vertices = {0, 1}}), "nothing was thrown");
  EXPECT_EQ(message({.vertices = {5, 5, 7}}), "nothing was thrown");
  std::vector<Index> all(126);
  std::iota(all.begin(), all.end(), Index{0});
  EXPECT_EQ(message({.faces = all}), "no face is left: all of them are avoided");
}

}  // namespace
}  // namespace geodesic
