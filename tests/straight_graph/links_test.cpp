// Which links a vertex has, and which of them continue a path.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/straight_graph/builder.h"

namespace geodesic::straight_graph {
namespace {

constexpr double kLongest = 1 + 1.0 / (1 << 17);

/// The grid of a lattice with base vectors (1, 0) and (shear, 1), and vertex `middle` in it.
struct Lattice {
  static constexpr int kCells = 40;
  double shear;
  Mesh mesh;

  explicit Lattice(double sheared) : shear(sheared), mesh(soup(sheared)) {}
  static TriangleSoup soup(double shear) {
    TriangleSoup grid =
        generate("grid", {{"columns", kCells}, {"rows", kCells}, {"diagonal", "forward"}});
    for (Vec3& p : grid.positions) p = {p[0] + shear * p[1], p[1], 0};
    return grid;
  }
};

std::vector<Index> targets(std::span<const Link> links) {
  std::vector<Index> of;
  for (const Link& link : links) of.push_back(link.target());
  return of;
}

Vec3 between(const Mesh& mesh, Index a, Index b) {
  return subtract(mesh.position(b), mesh.position(a));
}

/// The angle from a to b, counter-clockwise seen from above.
double turn(const Vec3& a, const Vec3& b) { return std::atan2(cross(a, b)[2], dot(a, b)); }

// A vector of the lattice with coprime coordinates in the basis of a face's corner is the sum of
// its two parents in the Stern-Brocot tree.
TEST(Links, of_a_flat_lattice_are_its_farey_neighbourhood) {
  for (const double shear : {0.0, 0.3}) {
    for (const double alpha : {0.5, 0.2, 0.1}) {
      const Lattice lattice(shear);
      const Mesh& mesh = lattice.mesh;
      const Graph graph = build_graph(mesh, alpha, 1);
      const Index v = mesh.vertex_count() / 2;
      std::vector<Index> expected;
      for (Index u = 0; u < mesh.vertex_count(); ++u) {
        if (u == v) continue;
        for (const Index h : mesh.outgoing(v)) {
          const Vec3 a = between(mesh, v, mesh.head(h)), b = between(mesh, v, mesh.apex(h));
          const Vec3 to = between(mesh, v, u);
          const double area = cross(a, b)[2];
          const auto m = static_cast<int>(std::lround(cross(to, b)[2] / area));
          const auto n = static_cast<int>(std::lround(cross(a, to)[2] / area));
          if (m < 1 || n < 1 || std::gcd(m, n) != 1) continue;
          // The parents (i, j) and (m - i, n - j): i n - j m = 1.
          int i = 1;
          while ((i * n - 1) % m != 0) ++i;
          const int j = (i * n - 1) / m;
          const Vec3 right = add(scale(i, a), scale(j, b)), left = subtract(to, right);
          if (turn(right, left) > alpha) expected.push_back(u);
        }
      }
      std::vector<Index> found = targets(graph.block(v).links());
      std::ranges::sort(found);
      EXPECT_EQ(found, expected) << "shear " << shear << ", alpha " << alpha;
      EXPECT_EQ(graph.block(v).edges().size(), 6U);
    }
  }
}

TEST(Links, are_as_long_as_the_line_up_to_the_rounding_of_a_float) {
  const Lattice lattice(0.3);
  const Graph graph = build_graph(lattice.mesh, 0.2, 1);
  for (Index v = 0; v < lattice.mesh.vertex_count(); ++v) {
    for (const auto links : {graph.block(v).edges(), graph.block(v).links()}) {
      for (const Link& link : links) {
        const double line = norm(between(lattice.mesh, v, link.target()));
        EXPECT_GE(link.length(), line * (1 - 1e-15));
        EXPECT_LE(link.length(), line * kLongest * (1 + 1e-15));
      }
    }
  }
}

TEST(Links, are_never_shorter_than_they_are_and_zero_only_if_they_are) {
  for (const unsigned sector : {0U, 60U, kAnySector}) {
    EXPECT_EQ(Link(1, 0, sector).length(), 0);
    for (const double length : {1.0, 1 + 1e-15, 1e-18, 3.7e19, 2 - 1e-9}) {
      const Link link(1, length, sector);
      EXPECT_GE(link.length(), length);
      EXPECT_LE(link.length(), length * kLongest);
      EXPECT_EQ(link.sector(), sector);
    }
  }
}

// On the back of a plate, lines to a neighbour are as long as the edge on the front, up to
// rounding.
TEST(Links, along_edges_lead_to_all_neighbours_and_no_two_links_to_one_vertex) {
  std::vector<NamedMesh> meshes = random_meshes();
  for (Index i = 0; i < 20; ++i) {
    const Vec3 corner = {1 + 0.1 * i, 1 + 0.07 * i, 0};
    meshes.push_back({"plate " + std::to_string(i),
                      {{{0, 0, 0}, {1, 0, 0}, corner, {0, 1, 0}},
                       {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}}}});
  }
  for (const NamedMesh& each : meshes) {
    const Mesh mesh(each.soup);
    const Graph graph = build_graph(mesh, 0.2, 1);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      std::vector<Index> neighbours;
      for (const Index h : mesh.outgoing(v)) {
        neighbours.push_back(mesh.head(h));
        neighbours.push_back(mesh.apex(h));
      }
      std::ranges::sort(neighbours);
      neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
      std::vector<Index> edges = targets(graph.block(v).edges());
      std::vector<Index> all = targets(graph.block(v).links());
      all.insert(all.end(), edges.begin(), edges.end());
      std::ranges::sort(edges);
      std::ranges::sort(all);
      EXPECT_EQ(edges, neighbours) << each.name << ", vertex " << v;
      EXPECT_EQ(std::ranges::adjacent_find(all), all.end()) << each.name << ", vertex " << v;
      EXPECT_FALSE(std::ranges::binary_search(all, v)) << each.name << ", vertex " << v;
    }
  }
}

// In the plane the angle by which a path turns is seen from positions alone.
TEST(Links, that_continue_a_path_are_those_nearly_straight_ahead) {
  for (const double alpha : {0.2, 0.02}) {
    const Lattice lattice(0.3);
    const Mesh& mesh = lattice.mesh;
    const Graph graph = build_graph(mesh, alpha, 1);
    const double slack = kSlack * alpha, two_sectors = 2 * 2 * std::numbers::pi / kSectors;
    std::size_t with_units = 0;
    for (Index v = 0; v < mesh.vertex_count(); v += 7) {
      for (const Link& link : graph.block(v).links()) {
        const Block& block = graph.block(link.target());
        std::vector<Index> ahead;
        block.for_straight_on(link.sector(), [&](std::span<const Link> links) {
          for (const Link& each : links) ahead.push_back(each.target());
        });
        with_units += block.unit > 0;
        for (const Link& next : block.links()) {
          const double angle = std::abs(
              turn(between(mesh, v, link.target()), between(mesh, link.target(), next.target())));
          const bool goes_on = std::ranges::find(ahead, next.target()) != ahead.end();
          if (angle < slack - 1e-4) {
            EXPECT_TRUE(goes_on) << v << " " << link.target() << " " << next.target();
          }
          if (goes_on && block.unit == 0) {
            EXPECT_LE(angle, slack + two_sectors + 1e-4)
                << v << " " << link.target() << " " << next.target();
          }
        }
      }
    }
    EXPECT_EQ(with_units > 0, alpha == 0.02);
  }
}

}  // namespace
}  // namespace geodesic::straight_graph
