// What must not depend on how a mesh is written down: unit of length, numbers of vertices, order
// and first corner of faces.
#include <algorithm>
#include <numeric>
#include <utility>

#include "tests/conformance/solver_test.h"
#include "tests/oracles/random.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class Invariance : public SolverTest {};

std::vector<std::optional<std::uint64_t>> counters(const Recording& r) {
  return {r.window_propagations, r.valid_windows, r.window_limit,
          r.peak_wavefront,      r.strip_depth,   r.window_bytes};
}

TriangleSoup scaled(TriangleSoup soup, double factor) {
  for (Vec3& p : soup.positions) {
    for (double& c : p) c *= factor;
  }
  return soup;
}

TEST_P(Invariance, scaling_by_a_power_of_two_scales_distances_exactly_and_keeps_counters) {
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    Recording recording;
    const auto distances = ask(*prepare(mesh), mesh, from(1), &recording);
    for (const double factor : {0x1p10, 0x1p-30}) {
      const Mesh other(scaled(soup, factor));
      Recording other_recording;
      auto other_distances = ask(*prepare(other), other, from(1), &other_recording);
      for (double& d : other_distances) d /= factor;
      EXPECT_TRUE(identical(other_distances, distances)) << name << " times " << factor;
      EXPECT_EQ(counters(other_recording), counters(recording)) << name << " times " << factor;
    }
  }
}

std::vector<Index> shuffled(Index count, oracles::Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  for (Index i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

TEST_P(Invariance, renumbered_vertices_keep_their_distances) {
  NEEDS(is_exact());
  oracles::Random random(31);
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    const std::vector<Index> renumbered = shuffled(mesh.vertex_count(), random);
    TriangleSoup other = soup;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      other.positions[renumbered[v]] = soup.positions[v];
    }
    for (Triangle& t : other.triangles) {
      for (Index& v : t) v = renumbered[v];
    }
    const auto distances = solve(Mesh(other), renumbered[2]);
    std::vector<double> in_old_order;
    for (const Index v : renumbered) in_old_order.push_back(distances[v]);
    EXPECT_TRUE(agree(in_old_order, solve(mesh, 2))) << name;
  }
}

TEST_P(Invariance, numbering_along_the_surface_keeps_distances_and_sources) {
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh given(soup), renumbered(soup, Numbering::along_surface);
    for (const Index source : {Index{0}, given.vertex_count() - 1}) {
      EXPECT_TRUE(agree(solve(renumbered, source), solve(given, source)))
          << name << " from vertex " << source;
    }
  }
}

TEST_P(Invariance, reordered_and_rotated_faces_keep_the_distances) {
  NEEDS(is_exact());
  oracles::Random random(32);
  for (const auto& [name, soup] : oracles::random_meshes()) {
    TriangleSoup other{soup.positions, {}};
    for (const Index f : shuffled(static_cast<Index>(soup.triangles.size()), random)) {
      Triangle t = soup.triangles[f];
      std::rotate(t.begin(), t.begin() + random.below(3), t.end());
      other.triangles.push_back(t);
    }
    EXPECT_TRUE(agree(solve(Mesh(other), 2), solve(Mesh(soup), 2))) << name;
  }
}

TEST_P(Invariance, a_mesh_turned_inside_out_keeps_the_distances) {
  NEEDS(is_exact());
  for (const auto& [name, soup] : oracles::random_meshes()) {
    TriangleSoup other = soup;
    for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
    EXPECT_TRUE(agree(solve(Mesh(other), 2), solve(Mesh(soup), 2))) << name;
  }
}

FOR_EVERY_SOLVER(Invariance);

}  // namespace
}  // namespace geodesic::conformance
