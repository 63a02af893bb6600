#include "tests/generators/soup_topology.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace geodesic::testing {
namespace {

constexpr double kTwoPi = 6.283185307179586;

Vec3 between(const Vec3& a, const Vec3& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Sets of vertices that grow together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t v) { return parent_[v] == v ? v : parent_[v] = find(parent_[v]); }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

std::size_t count_groups(Groups& groups, const std::set<Index>& members) {
  std::set<std::size_t> roots;
  for (const Index v : members) roots.insert(groups.find(v));
  return roots.size();
}

std::size_t count_saddles(const TriangleSoup& soup, const std::set<Index>& boundary) {
  std::vector<double> angle(soup.positions.size(), 0);
  for (const Triangle& face : soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = soup.positions[face[k]];
      const Vec3 u = between(at, soup.positions[face[(k + 1) % 3]]);
      const Vec3 v = between(at, soup.positions[face[(k + 2) % 3]]);
      angle[face[k]] += std::atan2(length(cross(u, v)), dot(u, v));
    }
  }
  std::size_t saddles = 0;
  for (Index v = 0; v < angle.size(); ++v) {
    if (boundary.count(v) == 0 && angle[v] > kTwoPi * (1 + 1e-9)) ++saddles;
  }
  return saddles;
}

}  // namespace

SoupTopology topology_of(const TriangleSoup& soup) {
  SoupTopology result;
  std::map<std::pair<Index, Index>, int> half_edges;
  Groups connected(soup.positions.size()), on_loop(soup.positions.size());
  std::set<Index> used, boundary;
  for (const Triangle& face : soup.triangles) {
    const auto& [a, b, c] = face;
    const Vec3& corner = soup.positions[a];
    result.volume += dot(corner, cross(soup.positions[b], soup.positions[c])) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = face[k], to = face[(k + 1) % 3];
      if (half_edges[{from, to}]++ > 0) ++result.repeated_half_edges;
      connected.join(from, to);
      used.insert(from);
      const double edge = length(between(soup.positions[from], soup.positions[to]));
      result.least_edge = std::min(result.least_edge, edge);
      result.greatest_edge = std::max(result.greatest_edge, edge);
    }
  }
  for (const auto& [ends, times] : half_edges) {
    const bool has_twin = half_edges.count({ends.second, ends.first}) != 0;
    if (!has_twin || ends.first < ends.second) ++result.edges;
    if (has_twin) continue;
    ++result.boundary_edges;
    on_loop.join(ends.first, ends.second);
    boundary.insert({ends.first, ends.second});
  }
  result.isolated_vertices = soup.positions.size() - used.size();
  result.components = count_groups(connected, used);
  result.boundary_loops = count_groups(on_loop, boundary);
  result.saddles = count_saddles(soup, boundary);
  result.euler_characteristic = static_cast<long>(soup.positions.size() + soup.triangles.size()) -
                                static_cast<long>(result.edges);
  return result;
}

}  // namespace geodesic::testing
