// Generates triangulated spheres, and a mesh of two components that contains one.
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "meshes/connectivity.h"
#include "meshes/generators/families.h"

namespace geodesic {
namespace {

// Corners (0, +-1, +-golden) and their rotations; faces counter-clockwise seen from outside.
const double kGolden = (1 + std::sqrt(5.0)) / 2;
const std::array<Vec3, 12> kCorners = {{{-1, kGolden, 0},
                                        {1, kGolden, 0},
                                        {-1, -kGolden, 0},
                                        {1, -kGolden, 0},
                                        {0, -1, kGolden},
                                        {0, 1, kGolden},
                                        {0, -1, -kGolden},
                                        {0, 1, -kGolden},
                                        {kGolden, 0, -1},
                                        {kGolden, 0, 1},
                                        {-kGolden, 0, -1},
                                        {-kGolden, 0, 1}}};
constexpr std::array<Triangle, 20> kFaces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

/// The icosahedron with every face split into frequency^2 triangles. Ids: the 12 corners, then the
/// inner vertices of the edges, then those of the faces.
class Icosphere {
 public:
  Icosphere(Index frequency, double radius) : n_(frequency), radius_(radius) {
    check_face_count(20.0 * n_ * n_);
    soup_.positions.reserve(std::size_t{10} * n_ * n_ + 2);
    soup_.triangles.reserve(std::size_t{20} * n_ * n_);
    for (const Vec3& corner : kCorners) add_vertex(corner);
    for (const Triangle& face : kFaces) cut(face);
  }

  TriangleSoup take() { return std::move(soup_); }

 private:
  Index add_vertex(const Vec3& direction) {
    const auto& [x, y, z] = direction;
    const double scale = radius_ / std::sqrt(x * x + y * y + z * z);
    soup_.positions.push_back({x * scale, y * scale, z * scale});
    return static_cast<Index>(soup_.positions.size() - 1);
  }

  /// The point that is i / n of the way from corner a to b and j / n from a to c.
  Vec3 between(const Triangle& corners, Index i, Index j) const {
    const auto& [a, b, c] = corners;
    return add(add(scale(n_ - i - j, kCorners[a]), scale(i, kCorners[b])), scale(j, kCorners[c]));
  }

  /// Returns the vertex k / n of the way from corner a to corner b; creates it at the first call.
  Index on_edge(Index a, Index b, Index k) {
    if (k == 0) return a;
    if (k == n_) return b;
    if (a > b) return on_edge(b, a, n_ - k);
    auto [found, is_new] = first_on_edge_.try_emplace({a, b}, 0);
    if (is_new) {
      found->second = static_cast<Index>(soup_.positions.size());
      for (Index m = 1; m < n_; ++m) add_vertex(between({a, b, a}, m, 0));
    }
    return found->second + k - 1;
  }

  void cut(const Triangle& corners) {
    const auto [a, b, c] = corners;
    // Row j holds the n - j + 1 vertices at j / n of the way from a to c.
    std::vector<Index> row, next;
    for (Index i = 0; i <= n_; ++i) row.push_back(on_edge(a, b, i));
    for (Index j = 1; j <= n_; ++j) {
      next.clear();
      next.push_back(on_edge(a, c, j));
      const Index other_end = j < n_ ? on_edge(b, c, j) : c;
      for (Index i = 1; i + j < n_; ++i) next.push_back(add_vertex(between(corners, i, j)));
      if (j < n_) next.push_back(other_end);
      for (Index i = 0; i + j <= n_; ++i) {
        soup_.triangles.push_back({row[i], row[i + 1], next[i]});
        if (i + j < n_) soup_.triangles.push_back({row[i + 1], next[i + 1], next[i]});
      }
      std::swap(row, next);
    }
  }

  Index n_;
  double radius_;
  TriangleSoup soup_;
  std::map<std::array<Index, 2>, Index> first_on_edge_;
};

TriangleSoup make_icosphere(const CheckedParameters& parameters) {
  return Icosphere(parameters.integer("frequency"), parameters.real("radius")).take();
}

TriangleSoup make_two_components(const CheckedParameters& parameters) {
  TriangleSoup soup = generate("icosphere", {{"frequency", parameters.integer("frequency")}});
  soup.positions.push_back({2, 2, 2});
  const Index cells = parameters.integer("cells");
  TriangleSoup cube = generate(
      "box",
      {{"x-cells", cells}, {"y-cells", cells}, {"z-cells", cells}, {"spacing", 1.0 / cells}});
  for (Vec3& p : cube.positions) p[0] += 3;
  return side_by_side(std::move(soup), cube);
}

}  // namespace

std::vector<Family> spheres() {
  return {
      {{.name = "icosphere",
        .description = "icosahedron with every edge cut into `frequency` parts and pushed out to "
                       "the sphere, 10 frequency^2 + 2 vertices",
        .parameters = {integer_parameter("frequency", 16, 1, 8000, "parts of an edge"),
                       real_parameter("radius", 1, 1e-6, 1e6, "of the sphere")}},
       make_icosphere},
      {{.name = "two-components",
        .description = "a unit icosphere, then one isolated vertex, then a cube of side 1: each "
                       "unreachable from the others",
        .parameters = {integer_parameter("frequency", 10, 1, 4000, "of the icosphere"),
                       integer_parameter("cells", 8, 1, 4000, "along a side of the cube")}},
       make_two_components}};
}

}  // namespace geodesic
