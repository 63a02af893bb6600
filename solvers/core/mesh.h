// The solvers' mesh: flat, immutable, without state of any solver.
//
// Half-edge h = 3 f + k is the k-th side of face f, directed counter-clockwise, so that `next` and
// `previous` are arithmetic. Every half-edge has the planar frame that unfolding needs: its origin
// lies at (0, 0), its head at (length, 0), and the third vertex of its face, the apex, at (apex_x,
// apex_y) with apex_y >= 0. A window is stored in the frame of the half-edge whose face it is about
// to enter; its source therefore has y <= 0.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/numbering.h"
#include "solvers/core/prefetch.h"

namespace geodesic {

/// A directed side of a face, with the frame of its plane.
struct HalfEdge {
  double length;  ///< distance from origin to head, in the mesh's unit of length
  double apex_x;  ///< planar position of the face's third vertex in this half-edge's frame
  double apex_y;  ///< never negative; 0 in a zero-area face
  Index twin;     ///< the same edge seen from the other face; kNone on a boundary
  Index origin;   ///< vertex the half-edge starts from
};
static_assert(sizeof(HalfEdge) == 32, "two half-edges share a cache line");

/// How paths treat an edge that does not have exactly one face in each direction: an edge of more
/// than two faces, or of two faces that have it in the same direction.
enum class NonManifoldEdges : std::uint8_t {
  cut,     ///< it is a boundary edge of each of its faces
  crossed  ///< paths go from each of its faces into each of the others
};

/// The triangle mesh of the solvers; constant once it is built.
///
/// If paths cross non-manifold edges, every face is stored twice, seen from either side: face f,
/// and its mirror image f + given_face_count(), with its corners in the order 0, 2, 1. A line that
/// leaves a face through half-edge h enters each other face of the edge, in the image that has the
/// edge in the direction opposite to h, as a twin has (`for_each_sheet`). Lines that start in the
/// two images of a face never meet, except on one-sided surfaces.
class Mesh {
 public:
  /// Builds the structure in expected linear time, apart from one pass of angles.
  ///
  /// Two half-edges become twins when exactly one face has the edge in each direction.
  /// `non_manifold_edges` decides how paths cross other edges of several faces. At a boundary edge,
  /// paths pass its end vertices. Vertices may be isolated, and several fans of faces may share a
  /// vertex.
  /// @throws std::invalid_argument for an index out of range, a triangle that names a vertex twice,
  ///        a non-finite coordinate, a nonzero extent beyond 1e-20 or 1e20, or more elements than
  ///        an Index numbers
  Mesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
       Numbering numbering = Numbering::as_given,
       NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut)
      : Mesh(positions, triangles, {}, {}, numbering, non_manifold_edges) {}
  /// @param soup joined vertices, which no face may name, share the distance of the one that stands
  ///        for them; triangles that are left out keep their numbers
  /// @throws std::invalid_argument for the reasons above, and of check_names (mesh_input.h)
  explicit Mesh(const TriangleSoup& soup, Numbering numbering = Numbering::as_given,
                NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut)
      : Mesh(soup.positions, soup.triangles, soup.joined_to, soup.left_out, numbering,
             non_manifold_edges) {}

  /// A part of a mesh, with the frames and pseudo-sources of the whole mesh.
  struct Part {
    std::vector<Vec3> positions;
    /// First the half-edges of the part's faces. From index 3 * `faces` on, those of faces beyond
    /// the part: twins of the part's half-edges. No vertex lists them as outgoing.
    std::vector<HalfEdge> half_edges;
    Index faces = 0;
    std::vector<std::uint8_t> pseudo_source;  ///< by vertex
    double mean_edge_length = 0;
  };
  explicit Mesh(Part part);

  /// Translates between the vertex and face numbers of this class and the given ones.
  const MeshNumbers& numbers() const { return numbers_; }

  Index vertex_count() const { return static_cast<Index>(positions_.size()); }
  Index half_edge_count() const { return static_cast<Index>(half_edges_.size()); }
  Index face_count() const { return half_edge_count() / 3; }
  /// Number of faces without mirror images and without those that are left out.
  Index given_face_count() const {
    return crosses_non_manifold_edges() ? face_count() / 2 : face_count();
  }
  /// Number of external face numbers, those of faces that are left out among them.
  Index external_face_count() const {
    return external_faces_ == kNone ? given_face_count() : external_faces_;
  }
  Index edge_count() const { return edge_count_; }

  const HalfEdge& half_edge(Index h) const { return half_edges_[h]; }
  // A table: the branches of a comparison are mispredicted at every third call.
  static Index next(Index h) { return h + kToNext[h % 3]; }
  static Index previous(Index h) { return h + kToPrevious[h % 3]; }
  Index twin(Index h) const { return half_edges_[h].twin; }
  Index origin(Index h) const { return half_edges_[h].origin; }
  Index head(Index h) const { return half_edges_[next(h)].origin; }
  /// The vertex of the half-edge's face that lies opposite the half-edge.
  Index apex(Index h) const { return half_edges_[previous(h)].origin; }

  /// True when paths cross some non-manifold edge. Every face then has a mirror image.
  bool crosses_non_manifold_edges() const { return !next_sheet_.empty(); }
  NonManifoldEdges non_manifold_edges() const {
    return crosses_non_manifold_edges() ? NonManifoldEdges::crossed : NonManifoldEdges::cut;
  }
  /// The half-edge of the same edge in the other image of its face, in the opposite direction. This
  /// function and the next two require crosses_non_manifold_edges().
  Index mirrored(Index h) const {
    const Index half = half_edge_count() / 2, own = h < half ? h : h - half;
    return (h < half ? half : 0) + own - own % 3 + (2 - own % 3);
  }
  /// A half-edge of another face of the same edge, in the same direction; h itself at a boundary.
  Index next_sheet(Index h) const { return next_sheet_[h]; }
  /// True when the edge has more than two faces.
  bool is_branching(Index h) const { return next_sheet_[next_sheet_[h]] != h; }

  /// Calls visit(g) for each half-edge g whose twin a line enters when it leaves the face of h
  /// through h: in general for h alone, at a boundary for none.
  template <class Visit>
  void for_each_sheet(Index h, const Visit& visit) const {
    if (twin(h) == kNone) return;
    if (!crosses_non_manifold_edges()) return visit(h);
    const Index back = mirrored(h);
    for (Index g = h; twin(g) != back; g = next_sheet(g)) visit(g);
  }

  /// Half-edges that start at vertex v, one per face corner, in no particular order; empty when v
  /// is isolated. The second half of them are mirror images, if the mesh has any.
  std::span<const Index> outgoing(Index v) const& {
    return {outgoing_.data() + first_outgoing_[v], outgoing_.data() + first_outgoing_[v + 1]};
  }
  std::span<const Index> outgoing(Index v) const&& = delete;

  /// True when the corner between h and previous(h) is the last one of its fan, counter-clockwise.
  /// The edge of previous(h) then belongs to no half-edge that leaves the origin of h.
  bool is_last_of_fan(Index h) const { return twin(previous(h)) == kNone; }

  /// Calls visit(neighbour, edge, facing) for each edge at v. `edge` is its half-edge that leaves v
  /// or, at the end of a fan, the one that arrives; `facing` is the half-edge of the same face
  /// whose apex is the neighbour. Each edge comes once, except non-manifold ones: once for each of
  /// their faces if they are cut; and all edges come once more in mirror images, if the mesh has
  /// any.
  template <class Visit>
  void for_each_edge_at(Index v, const Visit& visit) const {
    for (const Index h : outgoing(v)) {
      const Index into = previous(h);
      visit(head(h), h, into);
      if (is_last_of_fan(h)) visit(origin(into), into, h);
    }
  }

  /// True where a shortest path may bend: the total angle is above 2 pi, or at a boundary above pi;
  /// several fans share the vertex; or it is a corner of a face so flat (kFlatFace) that rounding
  /// dominates its angles.
  bool is_pseudo_source(Index v) const { return pseudo_source_[v] != 0; }

  /// Sum of the face angles at v in radians; 0 for an isolated vertex. Recomputed by each call.
  double total_angle(Index v) const;
  /// True when an edge at v has a face on one side only. Recomputed by each call.
  bool is_boundary(Index v) const;

  /// True when several fans of faces share some vertex. Both ends of an edge of more than two faces
  /// are such vertices.
  bool has_non_manifold_vertices() const { return has_non_manifold_vertices_; }
  /// True when some face has an edge of length zero or no area.
  bool has_degenerate_faces() const { return has_degenerate_faces_; }
  /// True when some face is lower than kThinFace of one of its sides.
  bool has_thin_faces() const { return has_thin_faces_; }

  const Vec3& position(Index v) const { return positions_[v]; }
  std::span<const Vec3> positions() const& { return positions_; }
  std::span<const Vec3> positions() const&& = delete;
  /// Starts to load the half-edges of the face of h; h may be kNone.
  void prefetch_face(Index h) const {
    if (h == kNone) return;
    const HalfEdge* face = &half_edges_[h - h % 3];
    prefetch(face);
    prefetch(face + 2);
  }
  /// Starts to load the half-edges of all faces around a vertex; v may be kNone.
  void prefetch_faces_around(Index v) const {
    if (v == kNone) return;
    for (const Index h : outgoing(v)) prefetch_face(h);
  }
  Triangle triangle(Index f) const { return {origin(3 * f), origin(3 * f + 1), origin(3 * f + 2)}; }

  /// Mean length of the edges (not half-edges); 0 for a mesh without faces.
  double mean_edge_length() const { return mean_edge_length_; }

 private:
  static constexpr std::array<Index, 3> kToNext = {1, 1, Index{0} - 2};  // modulo 2^32
  static constexpr std::array<Index, 3> kToPrevious = {2, Index{0} - 1, Index{0} - 1};

  Mesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
       std::span<const Index> joined_to, const std::vector<bool>& left_out, Numbering numbering,
       NonManifoldEdges non_manifold_edges);

  /// @param faces numbers of the triangles that are faces
  void number_along_surface(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                            std::span<const Index> faces);
  void set_faces(std::span<const Triangle> triangles);
  bool link_twins();
  void add_mirror_images();
  void link_sheets();
  bool is_least_of_edge(Index h) const;
  std::span<const Index> given_corners(Index v) const;
  /// Uses the first `half_edges` half-edges only.
  void index_outgoing(Index half_edges);
  void compute_frames();
  void compute_frames_of_face(Index first);
  void classify_vertices();
  struct Fan {
    Index faces;
    bool closed;
  };
  Fan fan_at(Index v) const;
  bool has_angle_excess(Index v) const;

  MeshNumbers numbers_;
  std::vector<Vec3> positions_;
  std::vector<HalfEdge> half_edges_;
  std::vector<Index> first_outgoing_;  // vertex_count + 1 offsets into outgoing_
  std::vector<Index> outgoing_;
  std::vector<Index> next_sheet_;  // by half-edge; empty unless paths cross non-manifold edges
  std::vector<std::uint8_t> pseudo_source_;
  bool has_non_manifold_vertices_ = false;
  bool has_degenerate_faces_ = false;
  bool has_thin_faces_ = false;
  Index edge_count_ = 0;
  Index external_faces_ = kNone;  // kNone in a part: all of its faces
  double mean_edge_length_ = 0;
};

}  // namespace geodesic
