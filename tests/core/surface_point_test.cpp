#include "solvers/core/surface_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"
#include "solvers/core/last_segments.h"
#include "solvers/core/registry.h"
#include "tests/message_of.h"

namespace geodesic {
namespace {

TriangleSoup halved_square() {  // two faces that share the edge 0-2
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 3, 0}}};
}

double space_between(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }

TEST(SurfacePoint, in_a_corner_of_a_face_is_the_vertex) {
  const Mesh mesh(halved_square());
  EXPECT_EQ(point_in_face(mesh, 1, {0, 3, 0}), SurfacePoint(3));
  EXPECT_EQ(point_in_face(mesh, 0, {1, 1e-300, 0}), SurfacePoint(0));
  EXPECT_EQ(point_on_edge(mesh, 0, 2, 1), SurfacePoint(2));
}

TEST(SurfacePoint, of_one_edge_has_one_position_from_both_of_its_ends) {
  const Mesh mesh(halved_square());
  const Vec3 expected{0.25, 0.25, 0};
  EXPECT_EQ(position_of(mesh, point_on_edge(mesh, 0, 2, 0.25)), expected);
  EXPECT_EQ(position_of(mesh, point_on_edge(mesh, 2, 0, 0.75)), expected);
}

TEST(SurfacePoint, divides_weights_of_any_size_by_their_sum) {
  const Mesh mesh(halved_square());
  EXPECT_EQ(point_in_face(mesh, 0, {1e308, 1e308, 1e308}),
            point_in_face(mesh, 0, {1e-308, 1e-308, 1e-308}));
}

TEST(SurfacePoint, that_is_not_on_the_mesh_is_refused_with_the_reason) {
  const Mesh mesh(halved_square());
  const auto refused_in_face = [&](Index face, const std::array<double, 3>& weights) {
    return message_of<std::invalid_argument>([&] { point_in_face(mesh, face, weights); });
  };
  const auto refused_on_edge = [&](Index from, Index to, double share) {
    return message_of<std::invalid_argument>([&] { point_on_edge(mesh, from, to, share); });
  };
  EXPECT_EQ(refused_in_face(2, {1, 1, 1}), "face 2 is not in the mesh of 2 faces");
  EXPECT_EQ(refused_on_edge(1, 3, 0.5), "no edge joins vertices 1 and 3");
  EXPECT_EQ(refused_on_edge(1, 4, 0.5), "vertex 4 is not in the mesh of 4 vertices");
  EXPECT_THROW(point_on_edge(mesh, 0, 1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(point_in_face(mesh, 0, {1, 1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(point_in_face(mesh, 0, {1, 1, -1e-300}), std::invalid_argument);
  EXPECT_THROW(point_in_face(mesh, 0, {0, 0, 0}), std::invalid_argument);
  SurfacePoint unnormalised;
  unnormalised.face = 0;
  unnormalised.weights = {0.5, 0.5, 0.5};
  EXPECT_EQ(defect_of(mesh, unnormalised),
            "point in face 0 has the weights 0.5, 0.5, 0.5: none may be negative, their sum must "
            "be 1, and at most one may be 0");
  EXPECT_EQ(defect_of(mesh, SurfacePoint()), "point is neither a vertex nor in a face");
  SurfacePoint both = unnormalised;
  both.vertex = 3;
  EXPECT_EQ(defect_of(mesh, both), "point is vertex 3 and in face 0: one of the two must be kNone");
  SurfacePoint elsewhere = unnormalised;
  elsewhere.face = 2;
  for (const SurfacePoint& point :
       {unnormalised, both, elsewhere, SurfacePoint(), SurfacePoint(4)}) {
    EXPECT_EQ(message_of<std::invalid_argument>([&] { position_of(mesh, point); }),
              defect_of(mesh, point));
  }
}

/// Points inside faces and on edges.
std::vector<SurfacePoint> random_points(const Mesh& mesh, int count) {
  Random random(7);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const Index face = random.below(mesh.face_count());
    const double third = i % 2 == 0 ? 0 : random.between(0.1, 1);
    points.push_back(
        point_in_face(mesh, face, {random.between(0.1, 1), random.between(0.1, 1), third}));
  }
  return points;
}

// Points of the two numberings do not convert to each other; a mere number is an external one.
static_assert(!std::is_convertible_v<SurfacePoint, InternalPoint> &&
              !std::is_convertible_v<InternalPoint, SurfacePoint> &&
              std::is_convertible_v<Index, SurfacePoint> &&
              !std::is_convertible_v<Index, InternalPoint>);
static_assert(!std::is_convertible_v<Query, InternalQuery> &&
              !std::is_convertible_v<InternalQuery, Query>);

TEST(SurfacePoint, keeps_its_position_when_the_mesh_numbers_its_faces_anew) {
  const TriangleSoup soup = rough_sphere(1, 2, 0.3);
  const Mesh given(soup), renumbered(soup, Numbering::along_surface);
  for (const SurfacePoint& point : random_points(given, 40)) {
    EXPECT_EQ(position_of(given, point), position_of(renumbered, point));
  }
}

TEST(SurfacePoint, spreads_to_every_corner_and_side_of_its_faces_at_their_distances_in_space) {
  const Mesh mesh(rough_terrain(3, 6, 5, 0.5));
  for (const SurfacePoint& given : random_points(mesh, 40)) {
    const InternalPoint point = in_internal_numbers(mesh, given);
    const Vec3 at = position_of(mesh, point);
    int corners = 0, sides = 0;
    spread_from(
        mesh, point,
        [&](Index h, const Point2& from, double distance, bool) {
          ++corners;
          const HalfEdge& e = mesh.half_edge(h);
          EXPECT_NEAR(std::hypot(from.x - e.apex_x, from.y - e.apex_y), distance, 1e-14);
          EXPECT_NEAR(distance, space_between(at, mesh.position(mesh.apex(h))), 1e-14);
        },
        [&](Index h, const Point2& from) {
          ++sides;
          EXPECT_LE(from.y, 0);
          // `from` is in the frame of the twin, which starts at the head of h.
          EXPECT_NEAR(std::hypot(from.x, from.y), space_between(at, mesh.position(mesh.head(h))),
                      1e-14);
          EXPECT_NEAR(std::hypot(from.x - mesh.half_edge(h).length, from.y),
                      space_between(at, mesh.position(mesh.origin(h))), 1e-14);
        });
    const Index under = edge_under(point);
    const int faces = under != kNone && mesh.twin(under) != kNone ? 2 : 1;
    EXPECT_EQ(corners, 3 * faces);
    EXPECT_EQ(sides, under == kNone ? 3 : 2 * faces);
  }
}

TEST(SurfacePoint, beyond_its_edge_is_at_the_same_place) {
  const Mesh mesh(rough_sphere(1, 2, 0.3));
  for (const SurfacePoint& given : random_points(mesh, 40)) {
    const InternalPoint point = in_internal_numbers(mesh, given);
    const std::vector<InternalPoint> images = in_every_face(mesh, point);
    EXPECT_EQ(images.front(), point);
    ASSERT_EQ(images.size(), edge_under(point) == kNone ? 1u : 2u);
    if (images.size() == 1) continue;
    const InternalPoint& beyond = images[1];
    EXPECT_LT(space_between(position_of(mesh, point), position_of(mesh, beyond)), 1e-15);
    EXPECT_EQ(defect_of(mesh, in_external_numbers(mesh, beyond)), "");
  }
}

TEST(Query, with_a_source_in_a_face_is_refused_by_a_solver_that_knows_vertices_only) {
  const Mesh mesh(halved_square());
  std::vector<double> distances(4);
  const auto ask = [&] {
    make_solver("dijkstra", mesh)
        ->solve({.sources = {{.at = point_in_face(mesh, 0, {1, 1, 1})}}}, distances);
  };
  EXPECT_THROW(ask(), std::invalid_argument);
}

TEST(Query, that_stops_at_targets_keeps_what_is_nearer_than_the_farthest_of_them) {
  const Mesh mesh(rough_terrain(3, 12, 12, 0.5));
  std::vector<double> all(mesh.vertex_count()), stopped(mesh.vertex_count());
  const auto solver = make_solver("dijkstra", mesh);
  solver->solve({.sources = {{.at = 0}}}, all);
  solver->solve({.sources = {{.at = 0}}, .targets = {20, 3}, .stop_at_targets = true}, stopped);
  const double farthest = std::max(all[20], all[3]);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(stopped[v], all[v] <= farthest ? all[v] : kInfinity) << v;
  }
  EXPECT_THROW(solver->solve({.sources = {{.at = 0}}, .stop_at_targets = true}, stopped),
               std::invalid_argument);
}

TEST(Query, that_stops_at_a_target_in_a_face_knows_its_corners_or_a_nearer_way) {
  const Mesh mesh(halved_square());
  std::vector<double> distances(4);
  make_solver("dijkstra", mesh)
      ->solve({.sources = {{.at = 1}},
               .targets = {point_in_face(mesh, 1, {1, 1, 1})},
               .stop_at_targets = true},
              distances);
  EXPECT_EQ(distances[0], 1);
  EXPECT_EQ(distances[2], 1);
}

}  // namespace
}  // namespace geodesic
