#include "solvers/straight_graph/discs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "solvers/core/queues/key_heap.h"
#include "solvers/core/window_predicates.h"
#include "solvers/straight_graph/assemble.h"

namespace geodesic::straight_graph {
namespace {

/// Most windows that cross faces for a disc, per vertex of it. Thin faces may cause any number of
/// them; the disc then ends with the vertices that are nearer.
constexpr std::size_t kWindowsPerVertex = 256;

/// Exact distances from a vertex to its nearest ones: windows and pseudo-sources in the order of
/// distances, filtered by the distances known so far (Xin and Wang 2009). Of the arrays over the
/// mesh, only what a disc has touched is reset.
class Disc {
 public:
  Disc(const Mesh& mesh, Index size) : mesh_(mesh), size_(size), reached_(mesh.vertex_count()) {}

  /// Appends the block of a vertex: its edges, and the lines to vertices of its disc.
  void operator()(Index v, std::vector<Block>& lines) {
    links_.clear();
    spread(v);
    Block block{};
    for (const Index h : mesh_.outgoing(v)) {
      link(mesh_.head(h), mesh_.half_edge(h).length);
      link(mesh_.apex(h), mesh_.half_edge(Mesh::previous(h)).length);
    }
    block.edge_count = static_cast<std::uint32_t>(links_.size());
    for (const Index u : final_) link(u, kInfinity);
    block.link_count = static_cast<std::uint32_t>(links_.size()) - block.edge_count;
    append_block(block, links_, lines);
    forget();
  }

  /// Calls visit(Line) for the links of a vertex that are no edges.
  template <class Visit>
  void for_each_line(Index v, const Visit& visit) {
    spread(v);
    for (const Index u : final_) {
      const Reached& at = reached_[u];
      if (at.line == kInfinity || at.window == kNone) continue;
      const Waiting& w = windows_[at.window];
      visit({w.half_edge, at.line, {w.x, w.y}});
    }
    forget();
  }

 private:
  struct Reached {
    double distance = kInfinity;
    double line = kInfinity;  ///< length of a straight line, if that is no longer than `distance`
    bool is_linked = false;
    Index window = kNone;  ///< by which the line came; kNone along an edge
  };
  struct Waiting : Window {
    Index half_edge;   ///< the window is in its frame
    bool is_straight;  ///< its lines are straight from the centre, over faces with an area
  };

  /// Links a vertex once, if there is a line or an edge to it.
  /// @param edge length of the edge to it, or kInfinity
  void link(Index u, double edge) {
    Reached& at = reached_[u];
    const double length = std::min(at.line, edge);
    if (!at.is_linked && length < kInfinity) links_.emplace_back(u, length, kAnySector);
    at.is_linked = true;
  }

  /// False where rounding dominates the angles of a face: a line over it is not the same seen from
  /// its end.
  static bool has_area(const HalfEdge& e) { return e.apex_y > kFlatFace * e.length; }

  void forget() {
    for (const Index u : touched_) reached_[u] = {};
    touched_.clear();
  }

  /// Fills final_ with the nearest vertices of v, and reaches all neighbours.
  void spread(Index v) {
    queue_.clear();
    windows_.clear();
    final_.clear();
    touched_.push_back(v);
    reached_[v].distance = 0;
    leave(v, true);
    std::size_t most = kWindowsPerVertex * size_;
    while (!queue_.empty() && final_.size() < size_ && most > 0) {
      const auto next = queue_.pop();
      if (next.item >= mesh_.vertex_count()) {
        --most;
        cross_face(next.item - mesh_.vertex_count());
      } else if (next.key_value() == reached_[next.item].distance) {
        final_.push_back(next.item);
        if (mesh_.is_pseudo_source(next.item)) leave(next.item, false);
      }
    }
  }

  void push(double key, Index item) {
    queue_.push({std::bit_cast<std::uint64_t>(key), ++serial_, item});
  }

  void improve(Index u, double distance, bool is_line, Index window = kNone) {
    Reached& at = reached_[u];
    if (!(distance < at.distance)) return;
    if (at.distance == kInfinity) touched_.push_back(u);
    at = {distance, is_line ? distance : kInfinity, false, window};
    push(distance, u);
  }

  /// Follows the edges of a vertex, and sends windows into all faces around it.
  void leave(Index v, bool is_centre) {
    const double distance = reached_[v].distance;
    for (const Index h : mesh_.outgoing(v)) {
      improve(mesh_.head(h), distance + mesh_.half_edge(h).length, is_centre);
      improve(mesh_.apex(h), distance + mesh_.half_edge(Mesh::previous(h)).length, is_centre);
    }
    for (const Index h : mesh_.outgoing(v)) {
      const HalfEdge& edge = mesh_.half_edge(Mesh::next(h));
      const Point2 from = apex_from_beyond(edge);
      land(Mesh::next(h),
           {{0, edge.length, from.x, from.y, distance}, kNone, is_centre && has_area(edge)});
    }
  }

  /// Adds a window on the edge of h for the face beyond it, unless a path over an end of the edge
  /// is nowhere longer. The window is in the frame of the twin of h.
  void land(Index h, Waiting w) {
    const HalfEdge& edge = mesh_.half_edge(h);
    if (edge.twin == kNone || is_void(w, edge.length)) return;
    w.half_edge = edge.twin;
    const EndpointBounds ends(edge.length, reached_[mesh_.head(h)].distance,
                              reached_[edge.origin].distance);
    if (ends.beat(w)) return;
    push(least_distance(w), mesh_.vertex_count() + static_cast<Index>(windows_.size()));
    windows_.push_back(w);
  }

  void cross_face(Index window) {
    const Waiting w = windows_[window];
    const Index h = w.half_edge;
    const FaceFrame face = face_frame(mesh_, h);
    const WindowSight sight(w, {face.apex_x, face.apex_y});
    const bool left = sight.left(), right = sight.right();
    const bool is_straight = w.is_straight && has_area(mesh_.half_edge(h));
    if (left && right) {
      // A line that touches a vertex begins a new one there: seen from its end it may not exist.
      const bool is_line = is_straight && !sight.at_begin() && !sight.at_end();
      improve(mesh_.apex(h), distance_through(w, face.apex_x, face.apex_y), is_line, window);
    } else if (sight.reaches()) {
      improve(mesh_.apex(h), least_distance_to(w, face.apex_x, face.apex_y), false);
    }
    for_each_child(h, face, w, sight, [&](Index side, const Window& child) {
      land(side, {child, kNone, is_straight});
    });
  }

  const Mesh& mesh_;
  Index size_;
  std::vector<Reached> reached_;  // by vertex
  std::vector<Index> touched_, final_;
  std::vector<Waiting> windows_;
  KeyHeap<Index> queue_;  // vertices; from their number on, indices of windows_
  std::uint32_t serial_ = 0;
  std::vector<Link> links_;
};

}  // namespace

Graph build_disc_graph(const Mesh& mesh, Index size, unsigned threads) {
  return assemble(mesh.vertex_count(), threads, [&] { return Disc(mesh, size); });
}

FollowLinks follow_links_of_disc(const Mesh& mesh, Index size) {
  return [disc = std::make_shared<Disc>(mesh, size)](Index v, const auto& visit) {
    disc->for_each_line(v, visit);
  };
}

}  // namespace geodesic::straight_graph
