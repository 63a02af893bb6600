// A mesh cut into regions, each a mesh of its own, for wavefronts that work side by side
// (regional_wavefront.h).
//
// Every face belongs to one region. A vertex with faces in several regions is shared: each of them
// has a copy of it. Half-edges on the border of a region have twins in it that are portals: nobody
// enters their faces there, and what lands on them belongs to the region whose face that is.
#pragma once

#include <algorithm>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::edge_based {

/// A vertex or half-edge as it is numbered in a region.
struct InRegion {
  Index region;
  Index number;
};

struct Region {
  Mesh mesh;
  std::vector<Index> vertices;  ///< of the whole mesh, by number here; shared ones are last
  Index first_shared;
  Index first_portal_face;       ///< portal p is half-edge 3 first_portal_face + p
  std::vector<InRegion> beyond;  ///< by portal, the half-edge that it stands for
  /// Of the shared vertices, in turn, the copies in other regions, and where those of each begin.
  std::vector<InRegion> copies = {};
  std::vector<Index> first_copy = {0};
  std::vector<Index> neighbours = {};  ///< regions with copies of shared vertices, in order
};

/// Vertices of a region, at most, where nothing else is asked for: large regions cost less mail,
/// and there must be enough of them for the threads.
inline Index usual_region_size(const Mesh& mesh) {
  return std::clamp<Index>(mesh.vertex_count() / 32, 1024, 4096);
}

/// Faces by the region of their corners with the least number. Regions follow a space-filling curve
/// through boxes that are halved until each holds few vertices: they depend on the mesh alone.
class Regions {
 public:
  /// @param most vertices of a box
  /// @param threads that build them
  Regions(const Mesh& mesh, Index most, unsigned threads);

  Index size() const { return static_cast<Index>(regions_.size()); }
  const Region& operator[](std::size_t r) const { return regions_[r]; }
  InRegion face(Index f) const { return faces_[f]; }
  /// Calls visit(InRegion) for each copy of a vertex.
  template <class Visit>
  void for_each_copy(Index v, const Visit& visit) const {
    visit(first_copies_[v]);
    const Region& owner = regions_[first_copies_[v].region];
    if (first_copies_[v].number < owner.first_shared) return;
    const Index shared = first_copies_[v].number - owner.first_shared;
    for (Index i = owner.first_copy[shared]; i < owner.first_copy[shared + 1]; ++i) {
      visit(owner.copies[i]);
    }
  }
  /// The copy whose region has the least number.
  InRegion first_copy(Index v) const { return first_copies_[v]; }

 private:
  std::vector<InRegion> faces_;         // by face of the whole mesh
  std::vector<InRegion> first_copies_;  // by vertex of the whole mesh
  std::vector<Region> regions_;
};

}  // namespace geodesic::edge_based
