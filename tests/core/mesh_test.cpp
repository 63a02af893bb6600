#include "solvers/core/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <vector>

#include "meshes/connectivity.h"
#include "tests/message_of.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

constexpr double kRounding = 1e-15;

double distance(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

/// A unit square of two triangles; its second diagonal is missing.
TriangleSoup square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// The corner of a cube at vertex 0: three right angles.
TriangleSoup cube_corner() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}}};
}

TEST(Mesh, numbered_along_the_surface_translates_to_the_given_numbers_and_back) {
  const TriangleSoup soup = fan(50, 0.3, -0.3);
  const Mesh mesh(soup, Numbering::along_surface);
  ASSERT_FALSE(mesh.numbers().is_identity());
  std::vector<Triangle> given(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Triangle t = mesh.triangle(f);
    for (Index& v : t) v = mesh.numbers().external_vertex(v);
    given.at(mesh.numbers().external_face(f)) = t;
  }
  EXPECT_EQ(given, soup.triangles);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(mesh.position(mesh.numbers().internal_vertex(v)), soup.positions[v]);
    EXPECT_EQ(mesh.numbers().external_vertex(mesh.numbers().internal_vertex(v)), v);
  }
}

TEST(Mesh, is_numbered_along_the_surface_as_if_isolated_vertices_were_not_there) {
  const TriangleSoup soup = fan(50, 0.3, -0.3);
  const Mesh alone(soup, Numbering::along_surface);
  TriangleSoup more = soup;
  more.positions.insert(more.positions.begin(), {{1e9, 0, 0}, {0, 20, -3}});
  for (Triangle& t : more.triangles) {
    for (Index& v : t) v += 2;
  }
  const Mesh beside(more, Numbering::along_surface);
  for (Index v = 0; v < alone.vertex_count(); ++v) {
    EXPECT_EQ(beside.numbers().external_vertex(v), alone.numbers().external_vertex(v) + 2);
  }
}

TEST(Mesh, walks_around_a_face) {
  const Mesh mesh(square());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    EXPECT_EQ(Mesh::previous(Mesh::next(h)), h);
    EXPECT_EQ(Mesh::next(Mesh::next(Mesh::next(h))), h);
    EXPECT_EQ(mesh.head(h), mesh.origin(Mesh::next(h)));
    EXPECT_EQ(mesh.apex(h), mesh.head(Mesh::next(h)));
  }
}

TEST(Mesh, twins_run_opposite_and_have_the_same_length_bits) {
  const Mesh mesh(fan(7, 0.37, -0.37));
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index twin = mesh.twin(h);
    if (twin == kNone) continue;
    EXPECT_EQ(mesh.twin(twin), h);
    EXPECT_EQ(mesh.origin(twin), mesh.head(h));
    EXPECT_EQ(mesh.head(twin), mesh.origin(h));
    EXPECT_EQ(mesh.half_edge(twin).length, mesh.half_edge(h).length);
  }
}

TEST(Mesh, boundary_edges_have_no_twin) {
  const Mesh mesh(square());
  Index without = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) without += mesh.twin(h) == kNone;
  EXPECT_EQ(without, 4u);
  EXPECT_EQ(mesh.edge_count(), 5u);
  for (Index v = 0; v < 4; ++v) EXPECT_TRUE(mesh.is_boundary(v)) << v;
  EXPECT_FALSE(Mesh(fan(6, 0, 0)).is_boundary(0));
}

TEST(Mesh, lists_the_half_edges_that_leave_a_vertex) {
  const Mesh mesh(fan(5, 0, 0));
  EXPECT_EQ(mesh.outgoing(0).size(), 5u);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    for (const Index h : mesh.outgoing(v)) EXPECT_EQ(mesh.origin(h), v);
  }
}

TEST(Mesh, gives_each_edge_at_a_vertex_once_at_a_boundary_too) {
  for (const TriangleSoup& soup : {square(), cube_corner(), fan(5, 0, 0)}) {
    const Mesh mesh(soup);
    Index ends = 0;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      std::set<Index> neighbours;
      mesh.for_each_edge_at(v, [&](Index neighbour, Index edge, Index facing) {
        EXPECT_TRUE(neighbours.insert(neighbour).second) << v << " to " << neighbour;
        EXPECT_EQ(mesh.origin(edge) == v ? mesh.head(edge) : mesh.origin(edge), neighbour);
        EXPECT_TRUE(mesh.origin(edge) == v || mesh.head(edge) == v);
        EXPECT_EQ(mesh.apex(facing), neighbour);
        EXPECT_EQ(facing / 3, edge / 3);
        ++ends;
      });
    }
    EXPECT_EQ(ends, 2 * mesh.edge_count());
  }
}

TEST(Mesh, frames_keep_the_distances_of_the_face) {
  const Mesh mesh(cube_corner());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const HalfEdge& e = mesh.half_edge(h);
    const Vec3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.head(h)),
               &c = mesh.position(mesh.apex(h));
    EXPECT_NEAR(e.length, distance(a, b), kRounding);
    EXPECT_NEAR(std::hypot(e.apex_x, e.apex_y), distance(a, c), kRounding);
    EXPECT_NEAR(std::hypot(e.apex_x - e.length, e.apex_y), distance(b, c), kRounding);
    EXPECT_GE(e.apex_y, 0);
  }
}

TEST(Mesh, mean_edge_length_counts_every_edge_once) {
  EXPECT_NEAR(Mesh(square()).mean_edge_length(), (4 + std::numbers::sqrt2) / 5, kRounding);
  EXPECT_EQ(Mesh(TriangleSoup{}).mean_edge_length(), 0);
}

TEST(Mesh, total_angle_is_the_sum_of_the_corners) {
  EXPECT_NEAR(Mesh(cube_corner()).total_angle(0), 1.5 * std::numbers::pi, 4 * kRounding);
  EXPECT_NEAR(Mesh(fan(6, 0, 0)).total_angle(0), 2 * std::numbers::pi, 4 * kRounding);
}

TEST(Mesh, pseudo_sources_are_saddles_and_reflex_corners_of_boundaries) {
  EXPECT_FALSE(Mesh(cube_corner()).is_pseudo_source(0)) << "a convex vertex";
  EXPECT_FALSE(Mesh(fan(6, 0, 0)).is_pseudo_source(0)) << "a flat vertex";
  EXPECT_TRUE(Mesh(fan(6, 0.3, -0.3)).is_pseudo_source(0)) << "a saddle";
  EXPECT_TRUE(Mesh(fan(6, 1e-5, -1e-5)).is_pseudo_source(0)) << "a slight saddle";
  EXPECT_FALSE(Mesh(fan(6, 0, 0)).is_pseudo_source(1)) << "a convex corner of a boundary";
  TriangleSoup part = fan(6, 0, 0);
  part.triangles.resize(3);
  EXPECT_FALSE(Mesh(part).is_pseudo_source(0)) << "a vertex of a straight boundary";
  part = fan(6, 0, 0);
  part.triangles.resize(4);
  EXPECT_TRUE(Mesh(part).is_pseudo_source(0)) << "a reflex corner";
}

TEST(Mesh, an_isolated_vertex_has_nothing_around_it) {
  TriangleSoup soup = square();
  soup.positions.push_back({9, 9, 9});
  const Mesh mesh(soup);
  EXPECT_TRUE(mesh.outgoing(4).empty());
  EXPECT_FALSE(mesh.is_pseudo_source(4));
  EXPECT_FALSE(mesh.is_boundary(4));
  EXPECT_EQ(mesh.total_angle(4), 0);
}

TEST(Mesh, an_edge_of_three_faces_is_a_boundary_of_each) {
  TriangleSoup soup = square();
  soup.positions.push_back({0, 0, 1});
  soup.triangles.push_back({2, 0, 4});
  const Mesh mesh(soup);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) EXPECT_EQ(mesh.twin(h), kNone) << h;
  EXPECT_EQ(mesh.edge_count(), 9u);
  EXPECT_TRUE(mesh.has_non_manifold_vertices());
}

TEST(Mesh, an_edge_that_two_faces_have_in_one_direction_is_a_boundary_of_both) {
  TriangleSoup soup = square();
  std::swap(soup.triangles[1][0], soup.triangles[1][1]);
  const Mesh mesh(soup);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) EXPECT_EQ(mesh.twin(h), kNone) << h;
  EXPECT_EQ(mesh.edge_count(), 6u);
}

TEST(Mesh, lines_cross_an_edge_of_several_faces_from_each_image_into_one_of_every_other_face) {
  TriangleSoup soup = square();
  for (const double height : {1, 2}) {
    const Index top = static_cast<Index>(soup.positions.size());
    soup.positions.push_back({0, 0, height});
    soup.triangles.push_back({2, 0, top});
  }
  const Mesh mesh(soup, Numbering::as_given, NonManifoldEdges::crossed);
  ASSERT_TRUE(mesh.crosses_non_manifold_edges());
  EXPECT_EQ(mesh.given_face_count(), 4u);
  ASSERT_EQ(mesh.face_count(), 8u);
  EXPECT_EQ(mesh.edge_count(), 9u);
  int lines = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    EXPECT_EQ(mesh.mirrored(mesh.mirrored(h)), h);
    EXPECT_EQ(mesh.origin(mesh.mirrored(h)), mesh.head(h));
    std::vector<Index> faces;
    mesh.for_each_sheet(h, [&](Index g) {
      const Index into = mesh.twin(g);
      EXPECT_EQ(mesh.twin(into), g);
      EXPECT_EQ(mesh.origin(into), mesh.head(h));
      EXPECT_EQ(mesh.half_edge(into).length, mesh.half_edge(h).length);
      faces.push_back(into / 3 % 4);
    });
    const bool is_common = mesh.origin(h) + mesh.head(h) == 2;  // vertices 0 and 2
    EXPECT_EQ(faces.size(), is_common ? 3u : 0u);
    faces.push_back(h / 3 % 4);
    std::ranges::sort(faces);
    EXPECT_EQ(std::unique(faces.begin(), faces.end()), faces.end());
    lines += is_common;
  }
  EXPECT_EQ(lines, 8);
}

TEST(Mesh, of_flipped_faces_has_the_vertices_of_the_surface_when_their_edges_are_crossed) {
  TriangleSoup soup = fan(7, 0.4, -0.4);
  const Mesh clean(soup);
  for (const std::size_t face : {1u, 2u, 5u}) {
    std::swap(soup.triangles[face][0], soup.triangles[face][1]);
  }
  EXPECT_TRUE(Mesh(soup).is_boundary(0));
  const Mesh mesh(soup, Numbering::as_given, NonManifoldEdges::crossed);
  EXPECT_FALSE(mesh.has_non_manifold_vertices());
  EXPECT_EQ(mesh.edge_count(), clean.edge_count());
  EXPECT_NEAR(mesh.mean_edge_length(), clean.mean_edge_length(), kRounding);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(mesh.is_pseudo_source(v), clean.is_pseudo_source(v)) << v;
    EXPECT_EQ(mesh.is_boundary(v), clean.is_boundary(v)) << v;
    EXPECT_NEAR(mesh.total_angle(v), clean.total_angle(v), 4 * kRounding);
  }
}

TEST(Mesh, of_a_manifold_has_no_images_of_its_faces) {
  const Mesh mesh(fan(6, 0.3, -0.3), Numbering::as_given, NonManifoldEdges::crossed);
  EXPECT_FALSE(mesh.crosses_non_manifold_edges());
  EXPECT_EQ(mesh.face_count(), 6u);
}

TEST(Mesh, closed_fans_that_share_a_vertex_make_it_a_pseudo_source) {
  TriangleSoup soup = side_by_side(fan(6, 0, 0), fan(5, 4, 4));
  for (Triangle& t : soup.triangles) std::ranges::replace(t, 7u, 0u);
  const Mesh mesh(soup);
  EXPECT_FALSE(mesh.is_boundary(0));
  EXPECT_TRUE(mesh.is_pseudo_source(0));
  EXPECT_TRUE(mesh.has_non_manifold_vertices());
}

TEST(Mesh, open_fans_that_share_a_vertex_are_found) {
  const Mesh mesh(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                               {{0, 1, 2}, {0, 3, 4}}});
  EXPECT_TRUE(mesh.has_non_manifold_vertices());
}

TEST(Mesh, one_fan_at_every_vertex_is_manifold) {
  for (const TriangleSoup& soup : {square(), cube_corner(), fan(6, 0.3, -0.3), fan(3, 0, 0)}) {
    EXPECT_FALSE(Mesh(soup).has_non_manifold_vertices());
    EXPECT_FALSE(Mesh(soup).has_degenerate_faces());
  }
}

TEST(Mesh, corners_of_a_zero_area_face_are_pseudo_sources) {
  // A flat fan. One of its faces is collapsed onto the leg from 0 to 1.
  TriangleSoup soup = fan(6, 0, 0);
  soup.positions[2] = {0.5, 0, 0};
  const Mesh mesh(soup);
  EXPECT_TRUE(mesh.has_degenerate_faces());
  EXPECT_TRUE(mesh.is_pseudo_source(0));
}

TEST(Mesh, a_zero_length_edge_keeps_the_lengths_beside_it) {
  const Mesh mesh(TriangleSoup{{{1, 2, 3}, {1, 2, 3}, {4, 6, 3}}, {{0, 1, 2}}});
  const HalfEdge& e = mesh.half_edge(0);
  EXPECT_EQ(e.length, 0);
  EXPECT_EQ(std::hypot(e.apex_x, e.apex_y), 5);
  EXPECT_TRUE(mesh.has_degenerate_faces());
  for (Index h = 0; h < 3; ++h) EXPECT_TRUE(std::isfinite(mesh.half_edge(h).apex_x)) << h;
}

TEST(Mesh, refuses_what_has_no_distances) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TriangleSoup soup = square();
  soup.triangles[1][2] = 4;
  EXPECT_THROW(Mesh{soup}, std::invalid_argument) << "an index out of range";
  soup = square();
  soup.triangles[1][2] = 0;
  EXPECT_THROW(Mesh{soup}, std::invalid_argument) << "a vertex named twice";
  for (const double c : {nan, kInfinity, -kInfinity}) {
    soup = square();
    soup.positions[3][1] = c;
    EXPECT_THROW(Mesh{soup}, std::invalid_argument) << c;
  }
}

TEST(Mesh, refuses_extents_beyond_those_that_solvers_take) {
  const auto triangle = [](double size) {
    return TriangleSoup{{{0, 0, 0}, {3 * size, 0, 0}, {0, 4 * size, 0}}, {{0, 1, 2}}};
  };
  for (const double size : {0.0, 1e-20, 1.0, 1e19}) EXPECT_NO_THROW(Mesh(triangle(size))) << size;
  for (const double size : {1e-300, 1e-21, 1e20, 4e307}) {
    EXPECT_THROW(Mesh(triangle(size)), std::invalid_argument) << size;
  }
}

TEST(Mesh, refuses_joined_vertices_and_left_out_faces_that_do_not_fit) {
  const auto refused = [](std::vector<Index> joined_to, std::vector<bool> left_out) {
    TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}},
                      {{0, 1, 2}, {0, 2, 3}}};
    soup.joined_to = std::move(joined_to);
    soup.left_out = std::move(left_out);
    return message_of<std::invalid_argument>([&] { Mesh{soup}; });
  };
  EXPECT_EQ(refused({0, 1, 2, 3, 2}, {false, true}), "nothing was thrown");
  EXPECT_EQ(refused({0, 1}, {}), "joined_to has 2 numbers for 5 vertices");
  EXPECT_EQ(refused({0, 1, 2, 3, 7}, {}), "vertex 4 is joined to vertex 7, which is not there");
  EXPECT_EQ(refused({1, 4, 2, 3, 4}, {}),
            "vertex 0 is joined to vertex 1, which is joined to another one");
  EXPECT_EQ(refused({0, 1, 4, 3, 4}, {}),
            "face 0 names vertex 2, which is joined to vertex 4; it must name that one");
  EXPECT_EQ(refused({}, {true}), "left_out has 1 flags for 2 triangles");
}

}  // namespace
}  // namespace geodesic
