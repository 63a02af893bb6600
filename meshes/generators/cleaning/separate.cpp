#include <span>

#include "meshes/disjoint_sets.h"
#include "meshes/edges.h"
#include "meshes/generators/cleaning/steps.h"

namespace geodesic {

std::vector<Index> pair_half_edges(const TriangleSoup& soup) {
  std::vector<Index> twins(3 * soup.triangles.size(), kNone);
  const EdgeTable edges(soup.triangles, std::vector<bool>(soup.triangles.size(), true),
                        soup.positions.size());
  edges.for_each_edge([&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2) return;
    const Index h = sides[0].half_edge, g = sides[1].half_edge;
    if (origin_of(soup.triangles, h) == origin_of(soup.triangles, g)) return;
    twins[h] = g;
    twins[g] = h;
  });
  return twins;
}

// One pass is enough. The faces of a fan run the same way round, in a row whose two ends alone lack
// a neighbour. All faces at an edge (a, b) of the result are in the one fan of a: they are two at
// most, the ends of the row, and run along the edge in opposite directions.
std::vector<RepairAction> separate_sheets(TriangleSoup& soup) {
  const std::vector<Index> twins = pair_half_edges(soup);
  DisjointSets fans(twins.size());  // of corners, numbered as the half-edges from them
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != kNone) fans.join(h, next_in_face(twins[h]));
  }
  const std::size_t before = soup.positions.size();
  std::vector<bool> has_fan(before, false);
  for (Index h = 0; h < twins.size(); ++h) {
    const Index first = fans.find(h);  // the least corner of the fan: settled before h
    Index& v = soup.triangles[h / 3][h % 3];
    if (first != h) {
      v = origin_of(soup.triangles, first);
    } else if (has_fan[v]) {
      const Vec3 position = soup.positions[v];
      v = static_cast<Index>(soup.positions.size());
      soup.positions.push_back(position);
    } else {
      has_fan[v] = true;
    }
  }
  const std::size_t copies = soup.positions.size() - before;
  if (copies == 0) return {};
  return {{"copied_vertices", "copies made of vertices at which separate sheets of the surface met",
           copies}};
}

}  // namespace geodesic
