#include "solvers/chen_han/shadow.h"

#include <algorithm>
#include <optional>

#include "solvers/core/tolerance.h"

namespace geodesic::chen_han {
namespace {

enum class Turn { counter_clockwise, clockwise };

/// The next corner at the same vertex; kNone beyond a boundary. The half-edge that leaves the
/// vertex names a corner; the corner's other edge lies counter-clockwise of it.
Index next_corner(const Mesh& mesh, Index corner, Turn turn) {
  if (turn == Turn::counter_clockwise) return mesh.twin(Mesh::previous(corner));
  const Index twin = mesh.twin(corner);
  return twin == kNone ? kNone : Mesh::next(twin);
}

/// A corner met while turning, from its near edge to its far edge.
struct MetCorner {
  double near_length, far_length;
  double cosine, sine;  ///< of the angle between them
  bool is_degenerate() const { return !(sine > 0 && near_length > 0 && far_length > 0); }
};

MetCorner meet(const Mesh& mesh, Index corner, Turn turn) {
  const HalfEdge& e = mesh.half_edge(corner);
  const double other = mesh.half_edge(Mesh::previous(corner)).length;
  const double cosine = e.apex_x / other, sine = e.apex_y / other;
  return turn == Turn::counter_clockwise ? MetCorner{e.length, other, cosine, sine}
                                         : MetCorner{other, e.length, cosine, sine};
}

/// The point that a turn of pi from the arriving line reaches.
struct ShadowBorder {
  Index corner = kNone;  ///< kNone: the turn reached a boundary first
  double position = 0;   ///< on the opposite edge, from the head of its half-edge
};

/// @return nothing when a corner on the way has no reliable angle
std::optional<ShadowBorder> find_border(const Mesh& mesh, const Incoming& incoming, Turn turn) {
  const MetCorner first = meet(mesh, incoming.corner, Turn::counter_clockwise);
  if (first.is_degenerate()) return std::nullopt;
  // (x, y) is the straight continuation of the arriving line, in the frame whose x axis is the near
  // edge of the current corner and whose y axis points the way of the turn; y >= 0 up to the line.
  double x = -incoming.x, y = incoming.y;
  if (turn == Turn::counter_clockwise) {
    x = -(incoming.x * first.cosine + incoming.y * first.sine);
    y = incoming.x * first.sine - incoming.y * first.cosine;
  }
  // The shadow begins earlier by kShadowMargin.
  const double straight = x;
  x += kShadowMargin * y;
  y = std::max(y - kShadowMargin * straight, 0.0);
  for (Index corner = next_corner(mesh, incoming.corner, turn); corner != kNone;
       corner = next_corner(mesh, corner, turn)) {
    const MetCorner met = meet(mesh, corner, turn);
    if (met.is_degenerate() || corner == incoming.corner) return std::nullopt;
    const double beyond = x * met.sine - y * met.cosine;  // positive: the far edge lies beyond
    if (beyond > 0) {
      const double near_weight = y * met.near_length;
      const double part = near_weight / (beyond * met.far_length + near_weight);
      const double from_head = turn == Turn::counter_clockwise ? 1 - part : part;
      return ShadowBorder{corner, from_head * mesh.half_edge(Mesh::next(corner)).length};
    }
    x = x * met.cosine + y * met.sine;
    y = -beyond;
  }
  return ShadowBorder{};
}

bool is_in_one_fan(const Mesh& mesh, Index v, Index corner) {
  std::size_t met = 1;
  Index c = next_corner(mesh, corner, Turn::counter_clockwise);
  for (; c != corner && c != kNone; c = next_corner(mesh, c, Turn::counter_clockwise)) ++met;
  if (c == kNone) {
    c = next_corner(mesh, corner, Turn::clockwise);
    for (; c != kNone; c = next_corner(mesh, c, Turn::clockwise)) ++met;
  }
  return met == mesh.outgoing(v).size();
}

ShadowedEdge whole_edge(const Mesh& mesh, Index corner) {
  const Index across = Mesh::next(corner);
  return {across, 0, mesh.half_edge(across).length};
}

void add_everything(const Mesh& mesh, Index v, std::vector<ShadowedEdge>& edges) {
  for (const Index corner : mesh.outgoing(v)) edges.push_back(whole_edge(mesh, corner));
}

/// Adds the corners from `border` on, up to `last` or a boundary. @return whether it met `last`
bool add_from(const Mesh& mesh, const ShadowBorder& border, Turn turn, Index last,
              std::vector<ShadowedEdge>& edges) {
  for (Index c = border.corner; c != kNone; c = next_corner(mesh, c, turn)) {
    edges.push_back(whole_edge(mesh, c));
    if (c == border.corner) {
      (turn == Turn::counter_clockwise ? edges.back().end : edges.back().begin) = border.position;
    }
    if (c == last) return true;
  }
  return false;
}

}  // namespace

void find_shadow(const Mesh& mesh, Index v, const Incoming& incoming,
                 std::vector<ShadowedEdge>& edges) {
  edges.clear();
  if (incoming.corner == kNone ||
      (mesh.has_non_manifold_vertices() && !is_in_one_fan(mesh, v, incoming.corner))) {
    return add_everything(mesh, v, edges);
  }
  const auto left = find_border(mesh, incoming, Turn::counter_clockwise);
  const auto right = find_border(mesh, incoming, Turn::clockwise);
  if (!left || !right) return add_everything(mesh, v, edges);
  const Index last = right->corner;
  if (last != kNone && add_from(mesh, *left, Turn::counter_clockwise, last, edges)) {
    edges.back().begin = right->position;  // a saddle: the shadow lies between its borders
    return;
  }
  // A boundary vertex: the shadow lies between each border and the boundary.
  if (last == kNone) add_from(mesh, *left, Turn::counter_clockwise, kNone, edges);
  add_from(mesh, *right, Turn::clockwise, kNone, edges);
}

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
