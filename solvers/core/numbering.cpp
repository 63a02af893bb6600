#include "solvers/core/numbering.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace geodesic {
namespace {

constexpr unsigned kBits = kCurveBits / 3;  // of each coordinate

/// Inserts two zeros after each of ten bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  return (x | x << 2) & 0x09249249u;
}

/// Returns the cells of all vertices, in the order of vertices.
std::vector<OnCurve> cells_of(std::span<const Vec3> positions) {
  const Box box = box_around(positions);
  const double extent = box.half_extent();
  const double greatest = (1u << kBits) - 1;
  std::vector<OnCurve> cells(positions.size());
  for (Index v = 0; v < positions.size(); ++v) {
    std::uint32_t cell = 0;
    for (std::size_t k = 0; extent > 0 && k < 3; ++k) {
      const double share = (positions[v][k] / 2 - box.low[k] / 2) / extent;
      cell |= spread(static_cast<std::uint32_t>(share * greatest)) << k;
    }
    cells[v] = {cell, v};
  }
  return cells;
}

}  // namespace

MeshNumbers::MeshNumbers(std::vector<Index> given_vertices, std::vector<Index> given_faces)
    : given_(std::move(given_vertices)), given_faces_(std::move(given_faces)), own_(given_.size()) {
  for (Index v = 0; v < given_.size(); ++v) own_[given_[v]] = v;
}

Index MeshNumbers::internal_face(Index given) const {
  if (given_faces_.empty()) return given;
  return static_cast<Index>(std::ranges::find(given_faces_, given) - given_faces_.begin());
}

std::vector<OnCurve> cells_along_curve(std::span<const Vec3> positions) {
  std::vector<OnCurve> cells = cells_of(positions), sorted(cells.size());
  for (unsigned shift = 0; shift < kCurveBits; shift += kBits) {
    std::array<Index, (1u << kBits) + 1> first{};
    const auto digit = [shift](const OnCurve& c) { return c.cell >> shift & ((1u << kBits) - 1); };
    for (const OnCurve& c : cells) ++first[digit(c) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const OnCurve& c : cells) sorted[first[digit(c)]++] = c;
    cells.swap(sorted);
  }
  return cells;
}

std::vector<Index> order_by_least_vertex(std::span<const Triangle> triangles, Index vertices) {
  const auto least = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}); };
  std::vector<Index> first(std::size_t{vertices} + 1, 0), order(triangles.size());
  for (const Triangle& t : triangles) ++first[least(t) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  for (Index f = 0; f < triangles.size(); ++f) order[first[least(triangles[f])]++] = f;
  return order;
}

}  // namespace geodesic
