#include "meshes/repair.h"

#include "meshes/defects.h"
#include "meshes/orientation.h"

namespace geodesic {
namespace {

class Repairer {
 public:
  explicit Repairer(TriangleSoup& soup) : soup_(soup) {}

  std::vector<RepairAction> repair() {
    drop_unusable();
    // Edges of more than two faces stay so when faces are flipped.
    const EdgeTable edges(soup_.triangles, std::vector<bool>(soup_.triangles.size(), true),
                          soup_.positions.size());
    const Orientation orientation = orient(soup_.triangles, edges);
    flip_faces(orientation);
    cut_edges(edges, orientation);
    return actions_;
  }

 private:
  void did(std::string key, std::string text, std::size_t count, bool changed = true) {
    if (count > 0) actions_.push_back({std::move(key), std::move(text), count, changed});
  }

  void drop_unusable() {
    const FaceCensus census = take_census(soup_);
    did("dropped_index_out_of_range", "faces that name a vertex that is not there dropped",
        census.index_out_of_range.size());
    did("dropped_repeated_vertex", "faces that name a vertex twice dropped",
        census.repeated_vertex.size());
    did("dropped_at_non_finite_vertex", "faces at a vertex that is not finite dropped",
        census.at_non_finite_vertex.size());
    move_non_finite_vertices(census);
    did("dropped_repeated_face", "repeated faces dropped, the first of each kept",
        census.repeated_face.size());
    std::size_t kept = 0;
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f) {
      if (census.usable[f]) soup_.triangles[kept++] = soup_.triangles[f];
    }
    soup_.triangles.resize(kept);
  }

  void move_non_finite_vertices(const FaceCensus& census) {
    std::size_t moved = 0;
    for (std::size_t v = 0; v < soup_.positions.size(); ++v) {
      if (census.finite_vertices[v]) continue;
      soup_.positions[v] = {0, 0, 0};
      ++moved;
    }
    did("moved_non_finite_vertex", "vertices that are not finite moved to the origin, isolated",
        moved);
  }

  void flip_faces(const Orientation& orientation) {
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f) {
      if (orientation.flipped[f]) soup_.triangles[f] = flip(soup_.triangles[f]);
    }
    did("flipped_faces", "faces flipped to run the same way round as their neighbours",
        orientation.flips);
  }

  void cut_edges(const EdgeTable& edges, const Orientation& orientation) {
    std::size_t non_manifold = 0;
    edges.for_each_edge([&](std::span<const EdgeSide> sides) {
      if (sides.size() > 2) ++non_manifold;
    });
    did("cut_non_manifold_edges",
        "non-manifold edges cut, so that paths cross them at their end vertices only", non_manifold,
        false);
    did("cut_one_sided_edges",
        "edges cut because the surface has one side only, so that paths cross them at their end "
        "vertices only",
        orientation.one_sided_edges, false);
  }

  TriangleSoup& soup_;
  std::vector<RepairAction> actions_;
};

}  // namespace

std::vector<RepairAction> repair(TriangleSoup& soup) { return Repairer(soup).repair(); }

}  // namespace geodesic
