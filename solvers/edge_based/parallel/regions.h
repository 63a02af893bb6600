// A mesh cut into regions, each with a mesh of its own, for wavefronts that work in parallel
// (regional_wavefront.h).
//
// Every face belongs to one region. A vertex with faces in several regions is shared: each of them
// has a copy of it. Half-edges on the border of a region have twins in it that are called portals.
// Their faces are never entered there: windows that land on them belong to the region of that face.
#pragma once

#include <algorithm>
#include <vector>

#include "solvers/core/mesh.h"

namespace geodesic::edge_based {

/// A region and the number of a vertex or half-edge in it.
struct InRegion {
  Index region;
  Index number;
};

struct Region {
  Mesh mesh;
  std::vector<Index> vertices;  ///< numbers in the whole mesh, by number here; shared ones are last
  Index first_shared;
  Index first_portal_face;       ///< portal p is half-edge 3 first_portal_face + p
  std::vector<InRegion> beyond;  ///< by portal, the half-edge that it represents
  /// For each shared vertex in turn, its copies in other regions, and the index of its first copy.
  std::vector<InRegion> copies = {};
  std::vector<Index> first_copy = {0};
  std::vector<Index> neighbours = {};  ///< regions with copies of shared vertices, in order
};

/// Default for the largest number of vertices of a region: large regions cost less mail, but there
/// must be enough of them for the threads.
inline Index usual_region_size(const Mesh& mesh) {
  return std::clamp<Index>(mesh.vertex_count() / 32, 1024, 4096);
}

/// The regions of a mesh. Each face belongs to the least region of its corners. Regions follow a
/// space-filling curve through boxes that are halved until each holds few vertices: they depend on
/// the mesh alone.
class Regions {
 public:
  /// @param most largest number of vertices of a box
  /// @param threads threads that build the regions
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
  /// The copy in the region of least number.
  InRegion first_copy(Index v) const { return first_copies_[v]; }

 private:
  std::vector<InRegion> faces_;         // by face of the whole mesh
  std::vector<InRegion> first_copies_;  // by vertex of the whole mesh
  std::vector<Region> regions_;
};

}  // namespace geodesic::edge_based
