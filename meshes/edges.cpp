#include "meshes/edges.h"

#include <algorithm>

namespace geodesic {

EdgeTable::EdgeTable(std::span<const Triangle> triangles, const std::vector<bool>& usable,
                     std::size_t vertex_count) {
  const auto for_each_side = [&](auto&& visit) {
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      if (!usable[f]) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangles[f][k], triangles[f][(k + 1) % 3]);
        visit(EdgeSide{low, high, static_cast<Index>(3 * f + k)});
      }
    }
  };
  // Counting sort by the lower end, then each end's few edges by the higher one.
  std::vector<std::size_t> first(vertex_count + 1, 0);
  for_each_side([&](const EdgeSide& side) { ++first[side.low + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) first[v + 1] += first[v];
  sides_.resize(first[vertex_count]);
  std::vector<std::size_t> fill(first.begin(), first.end() - 1);
  for_each_side([&](const EdgeSide& side) { sides_[fill[side.low]++] = side; });
  const auto at = [&](std::size_t i) { return sides_.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(at(first[v]), at(first[v + 1]), [](const EdgeSide& a, const EdgeSide& b) {
      return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
    });
  }
}

}  // namespace geodesic
