#include "meshes/orientation.h"

namespace geodesic {
namespace {

// Across an edge of exactly two faces: the other face's half-edge; kNone elsewhere.
std::vector<Index> neighbours(std::size_t half_edges, const EdgeTable& edges) {
  std::vector<Index> across(half_edges, kNone);
  edges.for_each_edge([&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2) return;
    across[sides[0].half_edge] = sides[1].half_edge;
    across[sides[1].half_edge] = sides[0].half_edge;
  });
  return across;
}

}  // namespace

Orientation orient(std::span<const Triangle> triangles, const EdgeTable& edges) {
  const std::vector<Index> across = neighbours(3 * triangles.size(), edges);
  const auto agree = [&](Index h, Index g) {
    return origin_of(triangles, h) != origin_of(triangles, g);
  };
  Orientation result;
  result.flipped.assign(triangles.size(), false);
  std::vector<bool> reached(triangles.size(), false);
  std::vector<Index> queue;
  for (Index root = 0; root < triangles.size(); ++root) {
    if (reached[root]) continue;
    reached[root] = true;
    queue.assign(1, root);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index f = queue[next];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (across[h] == kNone) continue;
        const Index g = across[h] / 3;
        const bool turned = result.flipped[f] == agree(h, across[h]);
        if (!reached[g]) {
          reached[g] = true;
          result.flipped[g] = turned;
          result.flips += turned ? 1 : 0;
          queue.push_back(g);
        } else if (result.flipped[g] != turned && h < across[h]) {
          ++result.one_sided_edges;
        }
      }
    }
  }
  return result;
}

}  // namespace geodesic
