#include "solvers/variants/fast_marching/unfolded.h"

#include <algorithm>

namespace geodesic::fast_marching {
namespace {

double scalar_product(Point2 a, Point2 b, Point2 from) {
  return (a.x - from.x) * (b.x - from.x) + (a.y - from.y) * (b.y - from.y);
}

/// Returns the apex of a half-edge's face, given the unfolded ends of the half-edge.
Point2 unfolded_apex(const HalfEdge& e, Point2 origin, Point2 head) {
  const Point2 along{(head.x - origin.x) / e.length, (head.y - origin.y) / e.length};
  return {origin.x + e.apex_x * along.x - e.apex_y * along.y,
          origin.y + e.apex_x * along.y + e.apex_y * along.x};
}

}  // namespace

std::optional<Splitter> split_corner(const Mesh& mesh, Index h) {
  const HalfEdge& opposite = mesh.half_edge(h);
  const Point2 corner{opposite.apex_x, opposite.apex_y};
  const Point2 origin{0, 0}, head{opposite.length, 0};
  if (!(scalar_product(origin, head, corner) < 0)) return {};
  // The section lies between left and right, the ends of the edge that is crossed next.
  Point2 left = origin, right = head;
  Index crossed = h;
  for (int faces = 0; faces < kMostUnfolded; ++faces) {
    const Index beyond = mesh.twin(crossed);
    if (beyond == kNone || !(mesh.half_edge(beyond).length > 0)) return {};
    const Point2 apex = unfolded_apex(mesh.half_edge(beyond), right, left);
    if (scalar_product(head, apex, corner) < 0) {
      left = apex;
      crossed = Mesh::previous(beyond);
    } else if (scalar_product(origin, apex, corner) < 0) {
      right = apex;
      crossed = Mesh::next(beyond);
    } else {
      return Splitter{mesh.apex(beyond), h, apex};
    }
  }
  return {};
}

Splitters::Splitters(const Mesh& mesh)
    : first_(mesh.vertex_count() + 1), of_corner_(mesh.half_edge_count(), kNone) {
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (const auto splitter = split_corner(mesh, h)) splitters_.push_back(*splitter);
  }
  std::ranges::stable_sort(splitters_, {}, &Splitter::vertex);
  for (const Splitter& splitter : splitters_) ++first_[splitter.vertex + 1];
  for (Index v = 0; v < mesh.vertex_count(); ++v) first_[v + 1] += first_[v];
  for (Index i = 0; i < splitters_.size(); ++i) of_corner_[splitters_[i].opposite] = i;
}

}  // namespace geodesic::fast_marching
