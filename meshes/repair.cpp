#include "meshes/repair.h"

#include <algorithm>

#include "meshes/connectivity.h"
#include "meshes/defects.h"

namespace geodesic {
namespace {

std::vector<RepairAction> drop_unusable(TriangleSoup& soup) {
  FaceCensus census = take_census(soup);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    if (!census.finite_vertices[v]) soup.positions[v] = {0, 0, 0};
  }
  census.usable.flip();
  for (std::size_t f = 0; f < soup.left_out.size(); ++f) {
    if (soup.left_out[f]) census.usable[f] = false;
  }
  drop_faces(soup, census.usable);
  return {{"dropped_index_out_of_range", "faces that name a vertex that does not exist dropped",
           census.index_out_of_range.size(), true, DefectKind::index_out_of_range},
          {"dropped_repeated_vertex", "faces of fewer than three different vertices dropped",
           census.repeated_vertex.size(), true, DefectKind::repeated_vertex},
          {"dropped_at_non_finite_vertex", "faces at a vertex that is not finite dropped",
           census.at_non_finite_vertex.size(), true, DefectKind::non_finite_coordinate},
          {"moved_non_finite_vertex", "vertices that are not finite moved to the origin, isolated",
           static_cast<std::size_t>(std::ranges::count(census.finite_vertices, false)), true,
           DefectKind::non_finite_coordinate},
          {"dropped_repeated_face", "repeated faces dropped, the first of each kept",
           census.repeated_face.size(), true, DefectKind::repeated_face}};
}

}  // namespace

std::vector<RepairAction> repair(TriangleSoup& soup, NonManifoldEdges non_manifold_edges) {
  std::vector<RepairAction> done = drop_unusable(soup);
  // Flips do not change which edges have more than two faces.
  const EdgeTable edges(soup);
  const Orientation orientation = orient(soup.triangles, edges);
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (orientation.flipped[f]) soup.triangles[f] = flip(soup.triangles[f]);
  }
  done.push_back({"flipped_faces", "faces flipped to run the same way round as their neighbours",
                  orientation.flips, true, DefectKind::inconsistent_orientation});
  if (non_manifold_edges == NonManifoldEdges::cut) {
    std::size_t non_manifold = 0;
    edges.for_each_edge(
        [&](std::span<const EdgeSide> sides) { non_manifold += sides.size() > 2 ? 1U : 0U; });
    done.push_back({"cut_non_manifold_edges",
                    "non-manifold edges cut, so that paths cross them at their end vertices only",
                    non_manifold, false, DefectKind::non_manifold_edge});
    done.push_back({"cut_one_sided_edges",
                    "edges cut because the surface has one side only, so that paths cross them at "
                    "their end vertices only",
                    orientation.one_sided_edges, false, DefectKind::inconsistent_orientation});
  }
  std::erase_if(done, [](const RepairAction& action) { return action.count == 0; });
  return done;
}

}  // namespace geodesic
