#include "solvers/core/numbering.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
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

/// Returns the cells of some vertices, in their order.
std::vector<OnCurve> cells_of(std::span<const Vec3> positions, std::span<const Index> vertices) {
  Box box;
  for (const Index v : vertices) box.include(positions[v]);
  const double extent = box.half_extent();
  const double greatest = (1u << kBits) - 1;
  std::vector<OnCurve> cells;
  cells.reserve(vertices.size());
  for (const Index v : vertices) {
    std::uint32_t cell = 0;
    for (std::size_t k = 0; extent > 0 && k < 3; ++k) {
      const double share = (positions[v][k] / 2 - box.low[k] / 2) / extent;
      cell |= spread(static_cast<std::uint32_t>(share * greatest)) << k;
    }
    cells.push_back({cell, v});
  }
  return cells;
}

/// Sorts the vertices of each cell that has many of them along a curve in their own box, as where
/// one part of a mesh is far from all others.
/// @param cells in order
void refine(std::span<OnCurve> cells, std::span<const Vec3> positions) {
  constexpr std::ptrdiff_t kMany = 256;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto end = std::find_if(
        first, cells.end(), [cell = first->cell](const OnCurve& c) { return c.cell != cell; });
    if (end - first > kMany && end - first < std::ssize(cells)) {
      std::vector<Index> vertices;
      for (auto c = first; c != end; ++c) vertices.push_back(c->vertex);
      for (const OnCurve& c : cells_along_curve(positions, vertices)) (first++)->vertex = c.vertex;
    }
    first = end;
  }
}

std::vector<Index> inverse(const std::vector<Index>& order, std::size_t numbers) {
  std::vector<Index> places(numbers, kNone);
  for (Index i = 0; i < order.size(); ++i) places[order[i]] = i;
  return places;
}

}  // namespace

MeshNumbers::MeshNumbers(std::vector<Index> given_vertices, std::vector<Index> given_faces,
                         std::size_t external_faces)
    : given_(std::move(given_vertices)),
      given_faces_(std::move(given_faces)),
      own_(inverse(given_, given_.size())),
      own_faces_(inverse(given_faces_, external_faces)) {}

void MeshNumbers::join(std::span<const Index> joined_to) {
  const std::vector<Index> own = own_;
  for (std::size_t v = 0; v < own.size(); ++v) own_[v] = own[joined_to[v]];
}

std::vector<OnCurve> cells_along_curve(std::span<const Vec3> positions,
                                       std::span<const Index> vertices) {
  std::vector<OnCurve> cells = cells_of(positions, vertices), sorted(cells.size());
  for (unsigned shift = 0; shift < kCurveBits; shift += kBits) {
    std::array<Index, (1u << kBits) + 1> first{};
    const auto digit = [shift](const OnCurve& c) { return c.cell >> shift & ((1u << kBits) - 1); };
    for (const OnCurve& c : cells) ++first[digit(c) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const OnCurve& c : cells) sorted[first[digit(c)]++] = c;
    cells.swap(sorted);
  }
  refine(cells, positions);
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
