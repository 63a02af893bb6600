#include "solvers/variants/flip_out/intrinsic_mesh.h"

#include <cmath>
#include <stdexcept>

#include "solvers/core/tolerance.h"

namespace geodesic::flip_out {
namespace {

Point2 apex_of(const Mesh& mesh, Index h) {
  return {mesh.half_edge(h).apex_x, mesh.half_edge(h).apex_y};
}

/// A half-edge and its face in a plane.
struct Laid {
  Index half_edge;
  Point2 origin, head, apex;
};

/// Returns the point at a distance from the origin of h; a vertex if it is equal up to rounding.
InternalPoint point_on(const Mesh& mesh, Index h, double from_origin) {
  InternalPoint point;
  point.face = h / 3;
  const double at_head = from_origin / mesh.half_edge(h).length;
  if (!(at_head > 0)) return InternalPoint(mesh.origin(h));
  if (!(1 - at_head > 0 && 1 - at_head < 1)) {
    return InternalPoint(at_head < 0.5 ? mesh.origin(h) : mesh.head(h));
  }
  point.weights[Mesh::next(h) % 3] = at_head;
  point.weights[h % 3] = 1 - at_head;
  return point;
}

}  // namespace

IntrinsicMesh::IntrinsicMesh(const Mesh& mesh) : mesh_(mesh) {
  const Index inner = mesh.half_edge_count();
  for (Index h = 0; h < inner; ++h) {
    next_.push_back(Mesh::next(h));
    twin_.push_back(mesh.twin(h));
    origin_.push_back(mesh.origin(h));
    frame_.push_back({mesh.half_edge(h).length, apex_of(mesh, h)});
  }
  for (Index h = 0; h < inner; ++h) {
    if (twin_[h] != kNone) continue;
    twin_[h] = static_cast<Index>(twin_.size());
    next_.push_back(kNone);
    twin_.push_back(h);
    origin_.push_back(mesh.head(h));
    frame_.push_back({frame_[h].length, {}});
  }
}

Index IntrinsicMesh::between(Index from, Index to) const {
  for (const Index h : mesh_.outgoing(from)) {
    if (mesh_.head(h) == to) return h;
    if (mesh_.apex(h) == to) return twin_[Mesh::previous(h)];
  }
  throw std::runtime_error("no edge joins two vertices of a path along edges");
}

double IntrinsicMesh::angle(Index h) const {
  return std::atan2(frame_[h].apex.y, frame_[h].apex.x);
}

IntrinsicMesh::Direction IntrinsicMesh::direction_beside(Index h, double angle) const {
  const auto known = direction_.find(h);
  Direction direction = known == direction_.end()
                            ? Direction{h, angle}
                            : Direction{known->second.half_edge, known->second.angle + angle};
  // The loop uses angles of the mesh's own faces: faces of this object may be flipped.
  for (;;) {
    const HalfEdge& e = mesh_.half_edge(direction.half_edge);
    const double corner = std::atan2(e.apex_y, e.apex_x);
    const Index left = mesh_.twin(Mesh::previous(direction.half_edge));
    if (direction.angle <= corner || left == kNone) return direction;
    direction = {left, direction.angle - corner};
  }
}

void IntrinsicMesh::join(Index first, Index second, Index third) {
  next_[first] = second;
  next_[second] = third;
  next_[third] = first;
}

// h from a to b, with c to its left and d to its right, becomes h from d to c.
void IntrinsicMesh::flip(Index h) {
  const Index t = twin_[h];
  const Index to_c = next_[h], to_a = next_[to_c], to_d = next_[t], to_b = next_[to_d];
  const double length = frame_[h].length;
  const Point2 a{0, 0}, b{length, 0}, c = frame_[h].apex;
  const Point2 d{length - frame_[t].apex.x, -frame_[t].apex.y};
  changed_.insert(changed_.end(), {h, to_c, to_a, t, to_d, to_b});
  origin_[h] = origin_[to_b];
  origin_[t] = origin_[to_a];
  join(h, to_a, to_d);
  join(t, to_b, to_c);
  frame_[h].length = frame_[t].length = norm(Point2{c.x - d.x, c.y - d.y});
  for (const auto& [side, from, to, apex] : {Laid{h, d, c, a},
                                             {to_a, c, a, d},
                                             {to_d, a, d, c},
                                             {t, c, d, b},
                                             {to_b, d, b, c},
                                             {to_c, b, c, d}}) {
    const Point2 along{(to.x - from.x) / frame_[side].length,
                       (to.y - from.y) / frame_[side].length};
    const Point2 out{apex.x - from.x, apex.y - from.y};
    frame_[side].apex = {along.x * out.x + along.y * out.y, along.x * out.y - along.y * out.x};
  }
  direction_.erase(h);
  direction_.erase(t);
  direction_[t] = direction_beside(to_a, angle(to_a));
  direction_[h] = direction_beside(to_b, angle(to_b));
}

void IntrinsicMesh::reset() {
  for (const Index h : changed_) {
    next_[h] = Mesh::next(h);
    origin_[h] = mesh_.origin(h);
    frame_[h] = {mesh_.half_edge(h).length, apex_of(mesh_, h)};
  }
  changed_.clear();
  direction_.clear();
}

void IntrinsicMesh::trace(Index h, std::vector<InternalPoint>& points) const {
  const Index end = head(h);
  const auto flipped = direction_.find(h);
  if (flipped == direction_.end()) {
    points.emplace_back(end);
    return;
  }
  const double reach = kFlipEndReach * frame_[h].length;
  const auto ends_at = [&](Index vertex, Point2 at, Point2 aim) {
    return vertex == end && norm(Point2{at.x - aim.x, at.y - aim.y}) <= reach;
  };
  const auto& [first, angle] = flipped->second;
  const HalfEdge& e = mesh_.half_edge(first);
  Point2 from{0, 0}, aim{frame_[h].length * std::cos(angle), frame_[h].length * std::sin(angle)};
  if (!ends_at(mesh_.head(first), {e.length, 0}, aim)) {
    Index in = first;
    bool crosses_right = true;
    for (Index faces = 0; !ends_at(mesh_.apex(in), apex_of(mesh_, in), aim); ++faces) {
      const Index side = crosses_right ? Mesh::next(in) : Mesh::previous(in);
      if (mesh_.twin(side) == kNone || faces > mesh_.face_count()) {
        throw std::runtime_error("rounding has led a line of a flipped edge astray");
      }
      const FaceFrame frame = face_frame(mesh_, in);
      from = crosses_right ? frame.to_right(from.x, from.y) : frame.to_left(from.x, from.y);
      aim = crosses_right ? frame.to_right(aim.x, aim.y) : frame.to_left(aim.x, aim.y);
      in = mesh_.twin(side);
      points.push_back(point_on(mesh_, in, from.x - from.y * (aim.x - from.x) / (aim.y - from.y)));
      const Point2 tip = apex_of(mesh_, in);
      crosses_right = (aim.x - from.x) * (tip.y - from.y) > (aim.y - from.y) * (tip.x - from.x);
    }
  }
  points.emplace_back(end);
}

}  // namespace geodesic::flip_out
