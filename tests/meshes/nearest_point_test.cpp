// The tree of boxes finds the same points as a visit of every face.
#include "meshes/nearest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <thread>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

/// The nearest point of each face is searched by itself.
class EveryFace {
 public:
  explicit EveryFace(const Mesh& mesh) : mesh_(mesh) {
    for (Index f = 0; f < mesh.face_count(); ++f) {
      std::vector<Vec3> corners;
      for (const Index v : mesh.triangle(f)) corners.push_back(mesh.position(v));
      const std::vector<Triangle> one{{0, 1, 2}};
      searches_.emplace_back(faces_.emplace_back(corners, one, Numbering::as_given));
    }
  }

  NearestPoint nearest_to(const Vec3& place) const {
    NearestPoint nearest{{}, kInfinity};
    for (Index f = 0; f < searches_.size(); ++f) {
      const NearestPoint of_face = searches_[f].nearest_to(place);
      if (!(of_face.distance < nearest.distance)) continue;
      nearest = of_face;
      if (of_face.at.is_vertex()) {
        nearest.at = mesh_.numbers().external_vertex(mesh_.triangle(f)[of_face.at.vertex]);
      } else {
        nearest.at.face = mesh_.numbers().external_face(f);
      }
    }
    return nearest;
  }

 private:
  const Mesh& mesh_;
  std::deque<Mesh> faces_;
  std::deque<NearestPointSearch> searches_;
};

/// Places in and around the box of a mesh, some of them on the lattice of `step`, in which several
/// faces are nearest, and some at vertices.
std::vector<Vec3> places_around(const Mesh& mesh, double step) {
  Random random(8);
  const Box box = box_around(mesh.positions());
  const double margin = box.half_extent() / 2;
  std::vector<Vec3> places;
  for (int i = 0; i < 60; ++i) {
    Vec3 place;
    for (std::size_t k = 0; k < 3; ++k) {
      place[k] = random.between(box.low[k] - margin, box.high[k] + margin);
      if (i % 3 == 0) place[k] = std::round(place[k] / step) * step;
    }
    places.push_back(i % 3 == 1 ? mesh.position(random.below(mesh.vertex_count())) : place);
  }
  return places;
}

/// Compares distances to the last bit. Squares of distances decide which face is nearest, and
/// different ones may have the same root.
/// @param exact squares that differ have roots that differ: the points must be the same, too
void expect_what_every_face_gives(const TriangleSoup& soup, const std::string& name,
                                  bool exact = false) {
  for (const Numbering numbering : {Numbering::as_given, Numbering::along_surface}) {
    const Mesh mesh(soup, numbering);
    const NearestPointSearch search(mesh);
    const EveryFace every(mesh);
    for (const Vec3& place : places_around(mesh, 0.5)) {
      const NearestPoint found = search.nearest_to(place), expected = every.nearest_to(place);
      EXPECT_EQ(found.distance, expected.distance) << name;
      EXPECT_TRUE(!exact || found.at == expected.at) << name;
    }
  }
}

TEST(NearestPointSearch, finds_a_point_as_near_as_a_visit_of_every_face) {
  for (const auto& [name, soup] : random_meshes()) expect_what_every_face_gives(soup, name);
  expect_what_every_face_gives(with_flat_caps(rough_terrain(3, 12, 12, 0.5), 4, 5), "flat caps");
  expect_what_every_face_gives({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, "triangle", true);
}

TEST(NearestPointSearch, takes_the_least_of_the_nearest_faces) {
  TriangleSoup grid = generate("grid", {{"columns", 12}, {"rows", 9}});
  expect_what_every_face_gives(grid, "grid", true);
  for (Index f = 0, count = static_cast<Index>(grid.triangles.size()); f < count; ++f) {
    grid.triangles.push_back(grid.triangles[f]);
  }
  expect_what_every_face_gives(grid, "every face twice", true);
}

// Positions have few digits there: points that are computed may lie outside of their faces.
TEST(NearestPointSearch, finds_the_same_far_from_the_origin) {
  for (const double far : {1e7, 1e15}) {
    TriangleSoup soup = rough_terrain(7, 10, 10, 1);
    for (Vec3& p : soup.positions) p = add(p, {far, -far, far});
    expect_what_every_face_gives(soup, std::to_string(far));
  }
}

TEST(NearestPointSearch, begins_in_several_threads_at_once) {
  const Mesh mesh(rough_sphere(3, 3, 0.2));
  const NearestPointSearch search(mesh), alone(mesh);
  const Vec3 place{0.1, 0.2, 2};
  const SurfacePoint expected = alone.nearest_to(place).at;
  std::vector<SurfacePoint> found(4);
  {
    std::vector<std::jthread> threads;
    for (SurfacePoint& each : found) {
      threads.emplace_back([&] { each = search.nearest_to(place).at; });
    }
  }
  for (const SurfacePoint& each : found) EXPECT_EQ(each, expected);
}

}  // namespace
}  // namespace geodesic
