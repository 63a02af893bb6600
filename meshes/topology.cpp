#include "meshes/topology.h"

#include <limits>

#include "meshes/defects.h"

namespace geodesic {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

int to_int(std::size_t i) { return static_cast<int>(i); }
VertexHandle vertex_handle(std::size_t i) { return VertexHandle(to_int(i)); }

class Builder {
 public:
  explicit Builder(const TriangleSoup& soup) : soup_(soup) {
    if (6 * soup.triangles.size() > std::numeric_limits<int>::max() ||
        soup.positions.size() > std::numeric_limits<int>::max()) {
      throw MeshError("the mesh has more elements than OpenMesh can number (2^31)");
    }
  }

  Topology build() {
    take_oriented_faces();
    pair_half_edges();
    number_fans();
    topology_.surface.reserve(fan_count_, edge_count_, triangles_.size());
    add_vertices();
    add_faces();
    link_boundaries();
    return std::move(topology_);
  }

 private:
  // Fills triangles_ and file_faces_ with the usable faces, oriented.
  void take_oriented_faces() {
    const std::vector<bool> usable = take_census(soup_).usable;
    const EdgeTable edges(soup_.triangles, usable, soup_.positions.size());
    const Orientation orientation = orient(soup_.triangles, edges);
    for (Index f = 0; f < soup_.triangles.size(); ++f) {
      if (!usable[f]) continue;
      const Triangle& t = soup_.triangles[f];
      triangles_.push_back(orientation.flipped[f] ? flip(t) : t);
      file_faces_.push_back(f);
    }
    topology_.left_out_faces = soup_.triangles.size() - triangles_.size();
    topology_.flipped_faces = orientation.flips;
    topology_.one_sided_edges = orientation.one_sided_edges;
  }

  void pair_half_edges() {
    const EdgeTable edges(triangles_, std::vector<bool>(triangles_.size(), true),
                          soup_.positions.size());
    twins_ = geodesic::pair_half_edges(triangles_, edges);
    edges.for_each_edge([&](std::span<const EdgeSide> sides) {
      const bool paired = twins_[sides.front().half_edge] != kNone;
      edge_count_ += paired ? 1 : sides.size();
      if (!paired && sides.size() > 1) ++topology_.cut_edges;
    });
  }

  // vertex_of_[h]: the surface's vertex at the corner from which half-edge h starts.
  void number_fans() {
    DisjointSets fans = join_fans(twins_);
    fan_count_ = soup_.positions.size();
    vertex_of_.resize(twins_.size());
    std::vector<bool> has_fan(soup_.positions.size(), false);
    for (Index h = 0; h < twins_.size(); ++h) {
      const Index first = fans.find(h);  // the least corner of the fan: numbered before
      const Index v = origin_of(triangles_, h);
      if (first != h) {
        vertex_of_[h] = vertex_of_[first];
      } else if (!has_fan[v]) {
        vertex_of_[h] = v;
        has_fan[v] = true;
      } else {
        vertex_of_[h] = static_cast<Index>(fan_count_++);
        file_vertex_of_extra_.push_back(v);
      }
    }
    topology_.extra_fans = file_vertex_of_extra_.size();
  }

  void add_vertices() {
    Surface& surface = topology_.surface;
    surface.add_property(topology_.file_vertex, "file_vertex");
    const std::size_t in_file = soup_.positions.size();
    for (std::size_t i = 0; i < fan_count_; ++i) {
      const Index v = i < in_file ? static_cast<Index>(i) : file_vertex_of_extra_[i - in_file];
      const Vec3& p = soup_.positions[v];
      const VertexHandle added = surface.add_vertex({p[0], p[1], p[2]});
      surface.property(topology_.file_vertex, added) = v;
    }
  }

  void add_faces() {
    Surface& surface = topology_.surface;
    surface.add_property(topology_.file_face, "file_face");
    handles_.resize(twins_.size());
    for (Index h = 0; h < twins_.size(); ++h) {
      handles_[h] = twins_[h] < h  // made with the edge's other side; kNone is not less
                        ? surface.opposite_halfedge_handle(handles_[twins_[h]])
                        : surface.new_edge(vertex_handle(vertex_of_[h]),
                                           vertex_handle(vertex_of_[next_in_face(h)]));
      surface.set_halfedge_handle(vertex_handle(vertex_of_[h]), handles_[h]);
    }
    for (Index f = 0; f < triangles_.size(); ++f) {
      const FaceHandle face = surface.new_face();
      surface.property(topology_.file_face, face) = file_faces_[f];
      surface.set_halfedge_handle(face, handles_[3 * f]);
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        surface.set_face_handle(handles_[h], face);
        surface.set_next_halfedge_handle(handles_[h], handles_[next_in_face(h)]);
      }
    }
  }

  // Outside half-edge h runs another half-edge from its head to its origin. The next one of the
  // boundary starts at that origin, at the other end of the fan there, which a turn around the
  // origin finds. In OpenMesh a boundary vertex refers to the half-edge outside.
  void link_boundaries() {
    Surface& surface = topology_.surface;
    for (Index h = 0; h < twins_.size(); ++h) {
      if (twins_[h] != kNone) continue;
      Index other = previous_in_face(h);
      while (twins_[other] != kNone) other = previous_in_face(twins_[other]);
      const HalfedgeHandle next_outside = surface.opposite_halfedge_handle(handles_[other]);
      surface.set_next_halfedge_handle(surface.opposite_halfedge_handle(handles_[h]), next_outside);
      surface.set_halfedge_handle(vertex_handle(vertex_of_[h]), next_outside);
    }
  }

  const TriangleSoup& soup_;
  Topology topology_;
  std::vector<Triangle> triangles_;
  std::vector<Index> file_faces_;
  std::vector<Index> twins_;
  std::vector<Index> vertex_of_;
  std::vector<Index> file_vertex_of_extra_;
  std::vector<HalfedgeHandle> handles_;
  std::size_t fan_count_ = 0;
  std::size_t edge_count_ = 0;
};

// Sets of vertices of the surface that faces connect; counts those that have a face.
std::size_t count_sets_with_faces(const Surface& surface, DisjointSets& sets) {
  std::vector<bool> seen(surface.n_vertices(), false);
  std::size_t count = 0;
  for (const FaceHandle face : surface.faces()) {
    const VertexHandle corner = surface.from_vertex_handle(surface.halfedge_handle(face));
    const Index root = sets.find(static_cast<Index>(corner.idx()));
    if (!seen[root]) ++count;
    seen[root] = true;
  }
  return count;
}

DisjointSets join_along_edges(const Surface& surface) {
  DisjointSets sets(surface.n_vertices());
  for (const OpenMesh::EdgeHandle edge : surface.edges()) {
    const HalfedgeHandle h = surface.halfedge_handle(edge, 0);
    sets.join(static_cast<Index>(surface.from_vertex_handle(h).idx()),
              static_cast<Index>(surface.to_vertex_handle(h).idx()));
  }
  return sets;
}

}  // namespace

Topology build_topology(const TriangleSoup& soup) { return Builder(soup).build(); }

std::size_t count_boundary_loops(const Surface& surface) {
  std::vector<bool> seen(surface.n_halfedges(), false);
  std::size_t loops = 0;
  for (const HalfedgeHandle start : surface.halfedges()) {
    if (!surface.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())]) continue;
    ++loops;
    HalfedgeHandle h = start;
    do {
      seen[static_cast<std::size_t>(h.idx())] = true;
      h = surface.next_halfedge_handle(h);
    } while (h != start);
  }
  return loops;
}

std::size_t count_pieces(const Surface& surface) {
  DisjointSets sets = join_along_edges(surface);
  return count_sets_with_faces(surface, sets);
}

std::size_t count_components(const Topology& topology) {
  const Surface& surface = topology.surface;
  DisjointSets sets = join_along_edges(surface);
  for (const VertexHandle v : surface.vertices()) {
    sets.join(static_cast<Index>(v.idx()), surface.property(topology.file_vertex, v));
  }
  return count_sets_with_faces(surface, sets);
}

}  // namespace geodesic
