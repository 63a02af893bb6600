#include "solvers/chen_han/unreliable.h"

#include "solvers/core/tolerance.h"

namespace geodesic::chen_han {

std::vector<std::uint8_t> find_unreliable_vertices(const Mesh& mesh) {
  std::vector<std::uint8_t> corners(mesh.vertex_count());
  bool any = false;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const HalfEdge& e = mesh.half_edge(h);
    if (e.apex_y > kFlatFace * e.length && e.length > 0) continue;
    corners[mesh.origin(h)] = corners[mesh.head(h)] = corners[mesh.apex(h)] = 1;
    any = true;
  }
  if (!any) return corners;
  std::vector<std::uint8_t> marked = corners;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (corners[mesh.origin(h)] | corners[mesh.head(h)]) {
      marked[mesh.origin(h)] = marked[mesh.head(h)] = 1;
    }
  }
  return marked;
}

}  // namespace geodesic::chen_han
