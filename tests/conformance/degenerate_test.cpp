// Zero-length edges and zero-area faces, as real scans have them. They hang no solver (CTest ends a
// test that does), a zero-length edge is a distance of 0 between its ends, and distances elsewhere
// stay exact. A solver that does not support them must refuse the mesh.
#include <cmath>
#include <functional>

#include "datasets/generators/generators.h"
#include "tests/conformance/solver_test.h"
#include "tests/oracles/brute_force.h"
#include "tests/oracles/random.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

std::vector<double> straight_lines(const Mesh& mesh, Index source) {
  const Vec3& s = mesh.position(source);
  std::vector<double> lines;
  for (const Vec3& p : mesh.positions()) {
    lines.push_back(std::hypot(p[0] - s[0], p[1] - s[1], p[2] - s[2]));
  }
  return lines;
}

TriangleSoup flat_grid(Index columns, Index rows, const char* diagonal = "alternating") {
  return generators::generate("grid",
                              {{"columns", columns}, {"rows", rows}, {"diagonal", diagonal}});
}

class Degenerate : public SolverTest {
 protected:
  void check(const TriangleSoup& soup) const {
    for_some_sources(soup, [&](const Mesh& mesh, Index source, const std::vector<double>& got) {
      EXPECT_TRUE(correct(got, oracles::brute_force_distances(mesh, source)))
          << "from vertex " << source;
    });
  }

  /// For meshes so degenerate that brute force sees no line but the edges: an upper bound only.
  void check_bounds(const TriangleSoup& soup) const {
    for_some_sources(soup, [&](const Mesh& mesh, Index source, const std::vector<double>& got) {
      EXPECT_TRUE(bound_from_above(got, straight_lines(mesh, source))) << "from vertex " << source;
      EXPECT_TRUE(bound_from_above(oracles::brute_force_distances(mesh, source), got))
          << "from vertex " << source;
    });
  }

 private:
  using Check = std::function<void(const Mesh&, Index, const std::vector<double>&)>;

  void for_some_sources(const TriangleSoup& soup, const Check& check_distances) const {
    const Mesh mesh(soup);
    ASSERT_TRUE(mesh.has_degenerate_faces());
    if (!abilities().degenerate_faces) {
      EXPECT_THROW(prepare(mesh), std::invalid_argument);
      return;
    }
    const auto solver = prepare(mesh);
    for (const Index source : {Index{0}, mesh.vertex_count() / 2, mesh.vertex_count() - 1}) {
      const auto got = ask(*solver, mesh, from(source));
      EXPECT_TRUE(satisfies_edges(mesh, got)) << "from vertex " << source;
      check_distances(mesh, source, got);
    }
  }
};

/// Moves one end of an edge in `one_in` onto the other.
TriangleSoup with_collapsed_edges(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in) {
  oracles::Random random(seed);
  for (const Triangle& t : soup.triangles) {
    if (random.below(one_in) == 0) soup.positions[t[0]] = soup.positions[t[1]];
  }
  return soup;
}

/// Splits faces in `one_in` at the middle of their first edge, on that face's side only, and fills
/// the slit with a face of no area.
TriangleSoup with_flat_caps(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in) {
  oracles::Random random(seed);
  const std::size_t faces = soup.triangles.size();
  for (std::size_t f = 0; f < faces; ++f) {
    if (random.below(one_in) != 0) continue;
    const auto [a, b, c] = soup.triangles[f];
    const Vec3 &p = soup.positions[a], &q = soup.positions[b];
    const Vec3 middle = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    const Index m = static_cast<Index>(soup.positions.size());
    soup.positions.push_back(middle);
    soup.triangles[f] = {a, m, c};
    soup.triangles.push_back({m, b, c});
    soup.triangles.push_back({a, b, m});
  }
  return soup;
}

TEST_P(Degenerate, zero_length_edges_in_a_plane) {
  check(with_collapsed_edges(flat_grid(8, 8), 1, 12));
}

TEST_P(Degenerate, zero_length_edges_on_a_rough_surface) {
  for (std::uint64_t seed = 2; seed < 6; ++seed) {
    check(with_collapsed_edges(oracles::rough_terrain(seed, 8, 8, 1), seed, 12));
    check(with_collapsed_edges(oracles::rough_sphere(seed, 2, 0.2), seed, 12));
  }
}

TEST_P(Degenerate, zero_area_faces_in_a_plane) { check(with_flat_caps(flat_grid(8, 8), 6, 5)); }

TEST_P(Degenerate, all_positions_equal) {
  TriangleSoup soup = oracles::rough_sphere(7, 1, 0.2);
  for (Vec3& p : soup.positions) p = {1, 2, 3};
  check(soup);
}

TEST_P(Degenerate, all_positions_on_a_line) {
  TriangleSoup soup = oracles::rough_terrain(8, 5, 5, 1);
  for (Vec3& p : soup.positions) p = {p[0], 0, 0};
  check_bounds(soup);
}

FOR_EVERY_SOLVER(Degenerate);

class Needles : public SolverTest {};

TEST_P(Needles, in_a_plane_keep_euclid) {
  // Every other column is 10^6 times narrower than its neighbour.
  TriangleSoup soup = flat_grid(10, 6, "backward");
  for (Vec3& p : soup.positions) {
    const double column = std::floor(p[0] / 2);
    p[0] = column + (p[0] > 2 * column ? 1e-6 : 0);
  }
  const Mesh mesh(soup);
  for (const Index source : {0u, 38u}) {
    EXPECT_TRUE(correct(solve(mesh, source), straight_lines(mesh, source)))
        << "from vertex " << source;
  }
}

FOR_EVERY_SOLVER(Needles);

}  // namespace
}  // namespace geodesic::conformance
